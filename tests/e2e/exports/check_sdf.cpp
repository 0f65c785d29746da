// check_sdf FILE.glb FOLDER [FILE.glb FOLDER …] — loads rigged.sdf of each folder by libsdformat, which resolves its
// poses and axes, and compares where all corners of all triangles are at half of each joint's range with what rig.json
// says. Prints a line an asset, and exits with 1 where one did not load or is off by more than 1e-4 of its size.
#if defined __GNUC__ && !defined __clang__
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized" /* gcc 12 with -fsanitize=address says so of std::regex */
#endif

#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <sdf/sdf.hh>
#include <sstream>
#include <string>
#include <vector>

extern "C" {
#include "rigged_asset.h"
}

namespace {

using Pose = ignition::math::Pose3d;
using Vector = ignition::math::Vector3d;

const double tolerance = 1e-4; // share of the asset's size
const double turn_each = -1;   // a thread's pitch is radians a metre, positive where it is left-handed

struct Outcome {
    int joints = 0;
    double worst = 0;
    bool failed = false;
};

bool report(const std::string& place, const sdf::Errors& errors) {
    for (const auto& error : errors) std::printf("  %s: %s\n", place.c_str(), error.Message().c_str());
    return errors.empty();
}

// The corners of an OBJ's triangles, in order.
std::vector<Vector> read_corners(const std::string& path) {
    std::ifstream file(path);
    std::vector<Vector> points, corners;
    std::string line, kind;
    while (std::getline(file, line)) {
        std::istringstream words(line);
        words >> kind;
        Vector p;
        size_t index = 0;
        if (kind == "v" && words >> p.X() >> p.Y() >> p.Z()) points.push_back(p);
        while (kind == "f" && words >> index) corners.push_back(points.at(index - 1));
    }
    return corners;
}

// Where a link goes when its own joint is at a value, in the frame of the model.
bool move(const sdf::Model& model, const std::string& link, double value, Pose& out) {
    for (uint64_t j = 0; j < model.JointCount(); j++) {
        const sdf::Joint& joint = *model.JointByIndex(j);
        if (joint.ChildLinkName() != link || joint.Type() == sdf::JointType::FIXED) continue;
        Pose frame;
        Vector axis;
        if (!report(link, joint.SemanticPose().Resolve(frame, "__model__")) ||
            !report(link, joint.Axis()->ResolveXyz(axis, "__model__")))
            return false;
        const bool slides = joint.Type() == sdf::JointType::PRISMATIC;
        const double way = slides                                  ? value
                           : joint.Type() == sdf::JointType::SCREW ? turn_each / joint.ThreadPitch() * value
                                                                   : 0;
        const ignition::math::Quaterniond turn(axis, slides ? 0 : value);
        out = Pose(frame.Pos() - turn * frame.Pos() + axis * way, turn);
        return true;
    }
    out = Pose::Zero;
    return true;
}

// Compares a link's meshes, moved by its own joint alone.
void compare(const rigged_asset& asset, const std::string& folder, const sdf::Model& model, const sdf::Link& link,
             Outcome& out) {
    const int part = rigged_part_called(&asset, link.Name().c_str());
    std::vector<double> values(static_cast<size_t>(asset.count) + 1, 0);
    Pose rest, moved;
    if (part >= 0 && part < asset.count) values[static_cast<size_t>(part)] = rigged_value(&asset, part, 0.5);
    out.joints += part >= 0 && part < asset.count;
    if (part < 0 || !report(link.Name(), link.SemanticPose().Resolve(rest, "__model__")) ||
        !move(model, link.Name(), values[static_cast<size_t>(part)], moved)) {
        out.failed = true;
        return;
    }
    size_t corner = 0;
    for (uint64_t v = 0; v < link.VisualCount(); v++) {
        const sdf::Visual& visual = *link.VisualByIndex(v);
        std::vector<Vector> corners = read_corners(folder + "/" + visual.Geom()->MeshShape()->Uri());
        corners.resize(rigged_node_corners(&asset.parts[part], static_cast<int>(v), corners.size()));
        for (const Vector& p : corners) {
            const Vector at = rest.CoordPositionAdd(visual.RawPose().CoordPositionAdd(p));
            const Vector there = moved.Pos() + moved.Rot() * at;
            double here[3];
            rigged_corner(&asset, part, corner++, values.data(), here);
            for (size_t k = 0; k < 3; k++) out.worst = std::fmax(out.worst, std::fabs(there[k] - here[k]) / asset.size);
        }
    }
    out.failed |= corner != asset.parts[part].corner_count;
}

Outcome check(const char* file, const std::string& folder) {
    Outcome out;
    rigged_asset asset;
    sdf::Root root;
    if (!rigged_open(file, folder.c_str(), &asset) || !report(folder, root.Load(folder + "/rigged.sdf")) ||
        !root.Model()) {
        out.failed = true;
        return out;
    }
    for (uint64_t l = 0; l < root.Model()->LinkCount(); l++)
        compare(asset, folder, *root.Model(), *root.Model()->LinkByIndex(l), out);
    int moving = 0;
    for (int p = 0; p < asset.count; p++) moving += asset.parts[p].moves;
    out.failed |= !(out.worst <= tolerance) || moving != out.joints;
    rigged_close(&asset);
    return out;
}

} // namespace

int main(int argc, char** argv) {
    int failed = 0, joints = 0;
    double worst = 0;
    for (int i = 1; i + 1 < argc; i += 2) {
        const Outcome out = check(argv[i], argv[i + 1]);
        std::printf("%s: %d joints, off by %.2g of the size%s\n", argv[i + 1], out.joints, out.worst,
                    out.failed ? ": FAILED" : "");
        failed += out.failed;
        joints += out.joints;
        worst = std::fmax(worst, out.worst);
    }
    std::printf("SDFormat %s: %d assets, %d joints, %d failed, off by %.2g of the size at most\n", SDF_VERSION_FULL,
                (argc - 1) / 2, joints, failed, worst);
    return failed > 0;
}

-- dragmesh: one library a room, the boundary on top, programs and tests around them. `scripts/build` runs it.
-- Read by premake5 as it is, and by Debian's premake4 through premake4.lua.

newoption { trigger = "cross", value = "TARGET", description = "Builds for another machine, into build/TARGET",
    allowed = { { "windows", "64-bit Windows, by mingw-w64" }, { "linux-arm64", "64-bit Arm" }, { "linux-arm32", "32-bit Arm" },
        { "web", "WebAssembly, by Emscripten" } } }
local cross = _OPTIONS["cross"]
local windows, web = cross == "windows", cross == "web"
-- Below build: what is made, and the objects of it.
local out, objects = cross or "%{cfg.buildcfg}", cross and "obj-" .. cross or "obj"

workspace "dragmesh"
    configurations(cross and { "release" } or { "release", "debug", "asan", "tsan", "fuzz" })
    location("build/make" .. (cross and "-" .. cross or ""))
    cdialect "C17"
    cppdialect "C++17"
    warnings "Extra"
    buildoptions { "-Wpedantic", "-Wconversion", "-Wno-sign-conversion", "-ffp-contract=off", "-fno-math-errno", "-fno-trapping-math" }
    -- clang 19 warns of 0.5 * WIDTH where an enum without a name holds WIDTH; in C that is an int, and the product exact.
    buildoptions { "-Wno-enum-float-conversion" }
    fatalwarnings { "All" }
    visibility "Hidden"
    pic(web and "Off" or "On")
    symbols(web and "Off" or "On")
    defines { "_GNU_SOURCE" }
    if web then buildoptions { "-msimd128" } end
    if windows then
        -- gcc bug 54412: the stack is aligned to 16 bytes, which aligned moves of wider registers do not bear.
        buildoptions { "-Wa,-muse-unaligned-vector-move" }
        -- mingw's isfinite and the like have branches for each type, all of which are compiled.
        buildoptions { "-Wno-float-conversion" }
        linkoptions { "-static" } -- libgcc, libstdc++ and winpthread: Windows has none of them
    end

    filter "configurations:release"
        optimize "Speed"
        defines { "NDEBUG" }
    filter "configurations:debug"
        optimize "Off"
    filter "configurations:asan or fuzz"
        optimize "On"
        sanitize { "Address", "UndefinedBehavior" }
        buildoptions { "-fno-sanitize-recover=undefined", "-fno-omit-frame-pointer" }
        linkoptions { "-fno-sanitize-recover=undefined" }
    filter "configurations:fuzz"
        -- clang's coverage; the targets alone link the engine. The checks left out need C++ in every program.
        buildoptions { "-fsanitize=fuzzer-no-link", "-fno-sanitize=vptr,function" }
        linkoptions { "-fno-sanitize=vptr,function" }
    filter "configurations:tsan"
        optimize "On"
        sanitize { "Thread" }
    filter {}

-- Whether a package with that header is there. Other machines have none here.
local function installed(header)
    if cross then return false end
    for _, folder in ipairs { "", "x86_64-linux-gnu/", "aarch64-linux-gnu/" } do
        if os.isfile("/usr/include/" .. folder .. header) then return true end
    end
    return false
end

newoption { trigger = "pick", value = "BACKEND", description = "What picks rays: Embree and our own code, one of them, or none",
    allowed = { { "auto", "both; Embree where its shared library is found at run time" }, { "embree", "Embree alone" },
        { "portable", "our own code alone" }, { "none", "nothing: hosts cast their own rays" } } }
local pick_choice = _OPTIONS["pick"] or (windows or web) and "portable" or "auto" -- Embree was never tried there
local pick_macros = ({ auto = {}, embree = { "DMI_NO_PORTABLE" }, portable = { "DMI_NO_EMBREE" },
    none = { "DMI_NO_EMBREE", "DMI_NO_PORTABLE" } })[pick_choice]

-- Libraries that are headers alone serve every machine; the rest of /usr/include is of this one.
local header_libraries = "build/include/header_libraries"
if cross then
    os.execute("mkdir -p " .. header_libraries .. " && ln -sfn /usr/include/stb " .. header_libraries)
end

-- Declares a program or library: its sources, the folders it may include from, and what it links.
local function make(name, kind_, sources, includes, libraries)
    project(name)
        kind(kind_)
        language "C"
        files(sources)
        includedirs(table.join(includes, { "third_party" }))
        if cross then externalincludedirs { header_libraries } end
        objdir("build/" .. objects .. "/" .. name)
        for _, name in ipairs(libraries) do
            if not (windows and name == "dl") then links { name } end -- Windows loads libraries by itself
        end
end

local function library(name, sources, includes, libraries)
    make(name, "StaticLib", sources, includes, libraries or {})
        targetdir("build/" .. out .. "/lib")
end

-- The interface's major version, which a shared library's name ends with.
local so_version = io.open("plugin_api/include/dragmesh/dragmesh.h"):read "*a":match "DM_VERSION_MAJOR (%d+)"

local function shared(name, sources, includes, libraries, map)
    make(name, "SharedLib", sources, includes, libraries)
        targetdir("build/" .. out)
        defines { "DM_BUILDING" }
        linkoptions { "-Wl,--gc-sections" }
        if windows then
            -- The import library in the format that Microsoft's linker, lld and ld take alike.
            local path = "../" .. out .. "/" .. name
            linkoptions { "-Wl,--output-def=" .. path .. ".def" }
            postbuildcommands { "@llvm-dlltool -m i386:x86-64 -d " .. path .. ".def -D " .. name .. ".dll -l " .. path .. ".lib" }
        else
            targetextension(".so." .. so_version)
            postbuildcommands { "@ln -sf lib" .. name .. ".so." .. so_version .. " ../" .. out .. "/lib" .. name .. ".so" }
            linkoptions { "-Wl,--version-script=../../" .. map, "-Wl,-z,defs", "-Wl,-Bsymbolic" }
        end
        filter "configurations:asan or tsan or fuzz"
            linkoptions { "-Wl,-z,undefs" }
        filter {}
end

-- Compiles a file of plugin_api/glibc into the project: the release build calls functions of the C library by versions that
-- glibc 2.31 has. pin.h says how.
local has_glibc = cross == "linux-arm64" or installed "gnu/libc-version.h"
local function pin(file, functions)
    if not has_glibc then return end
    files { "plugin_api/glibc/" .. file .. ".c" }
    filter "configurations:release"
        defines { "DMI_PIN_GLIBC" }
        for _, name in ipairs(functions) do linkoptions { "-Wl,--wrap=" .. name } end
    filter {}
end
local pinned = {
    dl = { "dlopen", "dlsym", "dlclose", "dlerror" },
    stat = { "fstat", "stat" },
    cpp_runtime = { "pthread_once", "__pthread_key_create", "_dl_find_object" },
    start = { "__libc_start_main", "hypot" },
}

-- gcc 12 for 64-bit Arm ends in an internal error where it makes vectors of a loop with fmin or fmax.
local function mind_gcc_12()
    if cross == "linux-arm64" then buildoptions { "-fno-tree-loop-vectorize" } end
end

local function program(name, sources, includes, libraries, folder)
    make(name, "ConsoleApp", sources, includes, libraries)
        if windows then links { "pthread" } end -- mingw's clock_gettime
        mind_gcc_12()
        targetdir("build/" .. out .. (folder or ""))
        if not windows then
            linkoptions { "-Wl,-rpath,'$$ORIGIN',-rpath,'$$ORIGIN/..',-rpath,'$$ORIGIN/../lib'" }
        end
end

-- Rooms ------------------------------------------------------------------------------------------------------------

-- The rooms of sdk, lowest first: { folder, rooms whose headers its files name }. docs/ARCHITECTURE.md explains the order;
-- tests/rooms.sh compares the rows with the includes, both ways.
local rooms = {
    { "base", {} },
    { "math", { "base" } },
    { "mesh", { "base", "math" } },
    { "pick", { "base", "math", "mesh" } },
    { "nn", { "base" } },
    { "segmentation", { "base", "math", "mesh", "nn" } },
    { "kinematics/analysis", { "base", "math", "mesh" } },
    { "kinematics/kpp", { "base", "math", "mesh", "nn" } },
    { "kinematics/candidates", { "math", "kinematics/analysis", "kinematics/kpp" } },
    { "kinematics/hints", { "math", "kinematics/candidates" } },
    { "kinematics/features", { "math", "nn", "kinematics/analysis", "kinematics/candidates" } },
    { "kinematics/ranking", { "base", "math", "nn", "kinematics/candidates", "kinematics/features" } },
    { "kinematics/limits", { "base", "math", "nn", "kinematics/analysis", "kinematics/candidates", "kinematics/features" } },
    { "kinematics/inference", { "math", "kinematics/kpp", "kinematics/candidates", "kinematics/hints", "kinematics/features",
        "kinematics/ranking", "kinematics/limits" } },
    { "kinematics/object", { "base", "math", "mesh", "pick", "kinematics/analysis", "kinematics/inference" } },
    { "motion", { "base", "math", "mesh", "nn" } },
    { "drag", { "math", "motion" } },
    { "assets", { "base", "math", "mesh", "nn", "kinematics/hints", "kinematics/object" } },
}

-- The rooms of dragmesh_gltf, in the same form: no room of the library itself includes from them.
local gltf_rooms = {
    { "gltf", { "base", "math", "mesh" } },
    { "export", { "base", "math", "mesh", "gltf" } },
}

-- Returns the room's folder and every room that its headers lead to: what the compiler has to find.
local function reached(room)
    local folders, known = {}, {}
    local function add(name)
        if known[name] then return end
        known[name] = true
        table.insert(folders, name)
        for _, row in ipairs(rooms) do
            if row[1] == name then
                for _, other in ipairs(row[2]) do add(other) end
            end
        end
    end
    add(room)
    return folders
end

-- Makes build/include/NAME, which holds a link to each of the folders `allowed` of `from`, and returns it. A header of any
-- other room is then not found.
local function include_folder(name, from, allowed)
    local folder = "build/include/" .. name
    os.execute("rm -rf " .. folder)
    for _, room in ipairs(allowed) do
        local parent, up = path.getdirectory(folder .. "/" .. room), path.getrelative(folder .. "/" .. room .. "/..", ".")
        os.execute("mkdir -p " .. parent .. " && ln -s " .. up .. "/" .. from .. "/" .. room .. " " .. folder .. "/" .. room)
    end
    return folder
end

-- Writes build/embed/NAME.c, which defines dmi_NAME, the bytes of `source`, and dmi_NAME_size, and returns its path. The
-- header `header` declares both. A file that is up to date stays as it is, so that make does not compile it again.
local function embed(name, source, header)
    local file = assert(io.open(source, "rb"), source .. " is missing")
    local bytes, rows = file:read("*a"), {}
    file:close()
    for first = 1, #bytes, 16 do
        rows[#rows + 1] = "    " .. table.concat({ bytes:byte(first, math.min(first + 15, #bytes)) }, ", ") .. ",\n"
    end
    local text = "/* The bytes of " .. source .. ". Written by premake5.lua: not to be edited. */\n" ..
        '#include "' .. header .. '"\n\n' ..
        "_Alignas(64) const unsigned char dmi_" .. name .. "[] = {\n" .. table.concat(rows) .. "};\n" ..
        "const size_t dmi_" .. name .. "_size = sizeof dmi_" .. name .. ";\n"
    local output = "build/embed/" .. name .. ".c"
    local old = io.open(output, "rb")
    local same = old ~= nil and old:read("*a") == text
    if old then old:close() end
    if same then return output end
    os.execute("mkdir -p build/embed")
    file = assert(io.open(output, "wb"))
    file:write(text)
    file:close()
    return output
end

-- Sources that the build makes for a room.
local made = {
    segmentation = { embed("part_finder_weights", "sdk/models/part_finder.safetensors",
        "segmentation/part_networks.h") },
    assets = { embed("asset_weights", "sdk/models/asset_parts.safetensors", "assets/asset_models.h") },
}

local api = "plugin_api/include"
local room_libraries = {}
for _, room in ipairs(rooms) do
    local name = "dragmesh_" .. room[1]:gsub("/", "_")
    table.insert(room_libraries, 1, name)
    local sources = table.join({ "sdk/" .. room[1] .. "/*.c" }, made[room[1]] or {})
    library(name, sources, { api, include_folder(name, "sdk", reached(room[1])) })
    -- Recorded operands of comparisons find a file's magic numbers; in geometry they are half of the time.
    if room[1]:find "kinematics/" and room[1] ~= "kinematics/object" or room[1] == "segmentation" then
        filter "configurations:fuzz"
            buildoptions { "-fno-sanitize-coverage=trace-cmp" }
        filter {}
    end
    if room[1] == "pick" then
        defines(pick_macros)
        if table.contains(pick_macros, "DMI_NO_EMBREE") then removefiles { "sdk/pick/embree*.c" } end
    end
end

-- cJSON under names of our own: neither the host's copy nor ours takes the other's calls.
library("cjson", { "third_party/cjson/cJSON.c" }, {})

-- Libraries --------------------------------------------------------------------------------------------------------

-- The boundary with all rooms and cJSON in one archive: the whole library for static linking, C alone.
local core_libraries = table.join(room_libraries, { "cjson" })
library("dragmesh_core", { "plugin_api/src/*.c" }, { api, "sdk" }, core_libraries)
    defines { "DM_BUILDING" }
    -- The archive is made anew from its objects and the rooms' archives: ar by itself only ever adds.
    local folder, add = "../" .. out .. "/lib/lib", ""
    for _, name in ipairs(core_libraries) do add = add .. " 'addlib " .. folder .. name .. ".a'" end
    postbuildcommands {
        "@(echo create $(TARGET).new; printf '%s\\n'" .. add .. "; printf 'addmod %s\\n' $(OBJECTS); echo save) | $(AR) -M",
        "@mv $(TARGET).new $(TARGET)" }

local core = { "dragmesh_core", "dl", "m" }

shared("dragmesh", { "plugin_api/src/interface.c" }, { api, "sdk" }, core, "plugin_api/dragmesh.map")
    pin("dl", pinned.dl)
    if not windows then
        filter "configurations:release"
            linkoptions { "-Wl,--no-as-needed,-l:libdl.so.2,--as-needed" } -- glibc 2.31 has the functions there
        filter {}
    end

-- The module that browsers and node load: the core, and the hooks of bindings/js. It exports every dm_* of the header.
if web then
    make("dragmesh_web", "ConsoleApp", { "bindings/js/module.c" }, { api }, { "dragmesh_core" })
        targetdir "build/web"
        targetname "dragmesh"
        targetextension ".wasm"
        linkoptions { "-O3", "--no-entry", "-sALLOW_MEMORY_GROWTH=1", "-sTOTAL_STACK=1MB", "-sWASM_BIGINT",
            "-sERROR_ON_UNDEFINED_SYMBOLS=0", "-sWARN_ON_UNDEFINED_SYMBOLS=0", "-Wl,--export=malloc", "-Wl,--export=free" }
        for line in io.lines(api .. "/dragmesh/dragmesh.h") do
            local name = line:match("^DM_API .*DM_CALL (dm_[%w_]+)%(")
            if name then linkoptions { "-Wl,--export=" .. name } end
        end
end

-- glTF in and out. The decoders of Draco and meshoptimizer are C++; a build without Draco refuses its extension by name.
library("meshoptimizer", { "third_party/meshoptimizer/*.cpp" }, {})
    language "C++"
    buildoptions { "-Wno-conversion" }
    -- A filter shifts negative numbers left: C++20 defines that, and so do gcc and clang for C++17.
    filter "configurations:asan or fuzz"
        buildoptions { "-fno-sanitize=shift-base" }
    filter {}
local has_draco = installed "draco/compression/decode.h"
local gltf_macros = has_draco and {} or { "DMI_NO_DRACO" }

-- Its sizes have 64 bits throughout: machines whose addresses have 32 do without it.
local has_gltf = cross ~= "linux-arm32"
if has_gltf then
    shared("dragmesh_gltf", { "sdk/gltf/*.c", "sdk/gltf/*.cpp", "sdk/export/*.c" },
        { api, include_folder("dragmesh_gltf", "sdk", { "base", "math", "mesh", "gltf", "export" }) },
        { "meshoptimizer", "dragmesh_core", "m" }, "plugin_api/dragmesh_gltf.map")
        language "C++"
        defines(gltf_macros)
        -- The archive, and a C++ runtime of its own: the host's copies of either are never called.
        if has_draco then linkoptions { "-l:libdraco.a" } end
        pin("stat", pinned.stat)
        pin("cpp_runtime", pinned.cpp_runtime)
        filter "configurations:release"
            linkoptions { "-static-libstdc++", "-static-libgcc" }
        filter {}
end

-- The procedural generator, and the library through which training sees the sdk's own samplers.
local generator = "training/generator"
if not cross then
    library("dragmesh_generator", { "training/generator/**.c" },
        { api, generator, include_folder("dragmesh_generator", "sdk", { "kinematics/hints" }) })
    -- Its files are most of a newcomer's build and run for milliseconds: -O1, which comes last, halves their time.
    filter "configurations:release"
        buildoptions { "-O1" }
    filter {}

    shared("dragmesh_lab", { "training/lab/*.c" }, { api, "sdk", generator },
        { "dragmesh_generator", "dragmesh_core", "dl", "m" }, "training/lab/lab.map")
end

-- Programs ---------------------------------------------------------------------------------------------------------

-- The tools: hosts of the public headers alone. A tool finds its own headers and those of tools/common, no other tool's.
local tools = { "tools/common", "samples/common" }
if has_gltf then
    library("dragmesh_tools", { "tools/common/*.c", "samples/common/*.c" }, table.join({ api }, tools))
        mind_gcc_12()

    for _, row in ipairs { { "dragmesh_cli", "dragmesh", "dragmesh" }, { "dragmesh_evaluate", "evaluate", "dragmesh-evaluate" } } do
        program(row[1], { "tools/" .. row[2] .. "/*.c" }, table.join({ api }, tools),
            { "dragmesh_tools", "dragmesh", "dragmesh_gltf", "cjson", "m" })
            targetname(row[3])
            pin("stat", pinned.stat)
            pin("start", pinned.start)
    end
end

if not cross then
    program("dragmesh_generate", { "training/generate/*.c", "samples/common/*.c" }, { api, "sdk", generator },
        { "dragmesh_generator", "dragmesh_gltf", "dragmesh", "cjson", "png", "m" })
end

-- What samples link beside the library; one whose library is missing is left out (scripts/install viewer).
local has_viewer = installed "SDL2/SDL.h" and installed "epoxy/gl.h"
local needs = {
    dynamic_load = { "dl" },
    host_memory_and_jobs = { "dragmesh", "pthread", "m" },
    many_objects = { "dragmesh", "pthread", "m" },
    prepare_offline = { "dragmesh", "dragmesh_gltf", "m" },
    gpu_skinning = { "dragmesh", "SDL2", "epoxy", "m" },
    vlm_intent = { "dragmesh", "curl", "cjson", "png", "m" },
    whole_host = { "dragmesh", "tinygltf", "m" },
}
local missing = { viewer = true, gpu_skinning = not has_viewer, vlm_intent = not installed "curl/curl.h",
    prepare_offline = not has_gltf, whole_host = not (installed "cglm/cglm.h" and installed "tiny_gltf.h") }

local writers = {} -- those that write files
for _, name in ipairs { "prepare_offline", "vlm_intent", "latch" } do writers[name] = "samples/common/*.c" end
writers.many_objects = { "samples/common/*.c", "samples/10_viewer/font.c" }

for _, source in ipairs(os.matchfiles("samples/**main.c")) do
    local name = source:match("samples/%d+_([%w_]+)/main.c")
    if name and not missing[name] then
        local sources = table.flatten { (source:gsub("main%.c$", "**.c")), writers[name] or {} }
        program("sample_" .. name, sources, { api }, needs[name] or { "dragmesh", "m" }, "/samples")
            local cpp = os.matchfiles((source:gsub("main%.c$", "*.cpp")))
            if #cpp > 0 then
                language "C++"
                files(cpp)
            end
    end
end

for _, source in ipairs(os.matchfiles("samples/09_recipes/*.c")) do
    program("recipe_" .. source:match("([%w_]+)%.c$"), { source }, { api }, { "dragmesh", "m" }, "/samples")
end

if has_viewer then
    local has_jpeg = installed "jpeglib.h"
    local scenes = { "samples/12_latch/game.c", "samples/12_latch/scene*.c", "samples/12_latch/script.c",
        "samples/12_latch/scenes/*.c" }
    local sources = table.join({ "samples/10_viewer/*.c", "samples/common/*.c" }, scenes)
    program("dragmesh_viewer", sources, { api }, table.join(
        { "dragmesh", "dragmesh_gltf", "SDL2", "epoxy", "png", "z", "m" }, has_jpeg and { "jpeg" } or {}))
        if not has_jpeg then defines { "VIEWER_NO_JPEG" } end
end

-- A host of the public header alone, by which compilers, machines and versions are compared (tests/abi/caller.c).
program("caller", { "tests/abi/caller.c" }, { api, "samples/common" }, { "dragmesh", "pthread" }, "/tests")

-- Tests: one program a file ------------------------------------------------------------------------------------------

local everything = table.join({ api, "sdk", generator, "tests/include", "tools/evaluate" }, tools)
-- Debian has cmocka for this machine alone; elsewhere a header of the same calls serves.
if cross then table.insert(everything, "tests/cross") end
local cmocka = cross and {} or { "cmocka" }
-- The tests of another machine are those of its list, if it has one. tests/e2e runs here, against the tool there.
local listed, list = {}, "tests/cross/" .. (cross or "") .. ".txt"
for name in os.isfile(list) and io.lines(list) or function() end do listed[name] = true end

-- Tests with a file in C++ beside them, and what that links; without the header of that library they are left out. It comes
-- first, because Debian's libdraco exports a tinygltf of its own.
local beside = { test_gltf_second_opinion = { source = "tests/e2e/tinygltf_scene.cpp", library = "tinygltf",
    found = installed "tiny_gltf.h" } }

for _, room in ipairs { "unit", "golden", "e2e", "abi" } do
    for _, source in ipairs(os.matchfiles("tests/" .. room .. "/test_*.c")) do
        local name = source:match("([%w_]+)%.c$")
        local libraries = { "dragmesh_core", "dl", "m" }
        if room == "abi" then libraries = { "dragmesh", "cjson", "dl", "m" } end
        if room == "e2e" then
            libraries = { "dragmesh", "cjson", "png", "dl", "m" }
        end
        if has_gltf then table.insert(libraries, 1, "dragmesh_gltf") end
        if not cross then table.insert(libraries, 1, "dragmesh_generator") end
        if name:find "gltf" and not cross then -- it compresses files itself
            libraries = table.join(libraries, { "meshoptimizer" }, has_draco and { "draco" } or {}, { "stdc++" })
        end
        local cpp = beside[name]
        if (not cross or listed[name]) and (not cpp or cpp.found) then
            program(name, { source }, everything, table.join(cpp and { cpp.library } or {}, cmocka, libraries), "/tests")
                if cpp then
                    language "C++"
                    files { cpp.source }
                end
                defines(gltf_macros)
                defines(pick_macros)
                if cross then defines { "DMI_NO_EMBREE" } end -- the library looks for it, and there is none to test with
                -- They call the core that they hold, not a library.
                if windows and room ~= "abi" then defines { "DM_STATIC" } end
                if room ~= "abi" then defines { "DM_TEST_ROOM=\"" .. room .. "\"" } end
        end
    end
end
if cross then return end

-- What simulators load of rigged assets, compared with ours (tests/e2e/exports.sh).
local exports = "tests/e2e/exports/"
if installed "mujoco/mujoco.h" then
    program("check_mujoco", { exports .. "check_mujoco.c", exports .. "rigged_asset.c" }, everything,
        { "mujoco", "dragmesh_gltf", "cjson", "m" }, "/tests")
end
if installed "mujoco/mujoco.h" and installed "GL/osmesa.h" then -- for scripts/pictures
    program("draw_mujoco", { exports .. "draw_mujoco.c" }, {}, { "mujoco", "OSMesa", "png", "m" }, "/tests")
end
if installed "sdformat-12.3/sdf/sdf.hh" then
    program("check_sdf", { exports .. "check_sdf.cpp", exports .. "rigged_asset.c" }, everything,
        { "sdformat12", "ignition-math6", "dragmesh_gltf", "cjson", "m" }, "/tests")
        language "C++"
        externalincludedirs { "/usr/include/sdformat-12.3", "/usr/include/ignition/math6", "/usr/include/ignition/utils1" }
end

-- A main for fuzz targets; an archive, so that libFuzzer's comes before it where that is linked.
library("fuzz_driver", { "tests/fuzz/driver.c" }, { api, "sdk" })

for _, source in ipairs(os.matchfiles("tests/fuzz/fuzz_*.c")) do
    local name, sources = source:match("([%w_]+)%.c$"), { source }
    if name == "fuzz_jobs" then sources = { source, "tools/common/*.c", "tools/dragmesh/*.c", "samples/common/*.c" } end
    program(name, sources, everything, { "fuzz_driver", "dragmesh_gltf", "dragmesh_core", "dl", "m" }, "/fuzz")
        if name == "fuzz_jobs" then defines { "main=dragmesh_main" } end
        filter "configurations:fuzz"
            linkoptions { "-fsanitize=fuzzer" }
        filter {}
end

-- Benchmarks that call Embree (and cglm) themselves too; without their headers they are left out.
local embree = installed "embree4/rtcore.h" and "embree4" or installed "embree3/rtcore.h" and "embree3"
local beside_embree = { bench_peers = installed "cglm/cglm.h", bench_pick = true, bench_level = true }

for _, source in ipairs(os.matchfiles("tests/bench/bench_*.c")) do
    local name, libraries = source:match("([%w_]+)%.c$"), { "dragmesh_gltf", "dragmesh_core", "dl", "m" }
    local sources = { source, "tests/bench/support.c", "tests/bench/world.c" }
    if beside_embree[name] then
        table.insert(sources, "tests/bench/bare_embree.c")
        table.insert(libraries, embree)
    end
    if beside_embree[name] == nil or embree and beside_embree[name] then program(name, sources, everything, libraries, "/bench") end
end

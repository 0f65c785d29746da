-- dragmesh: one library a room, the boundary on top, programs and tests round it. `scripts/build` runs it.
-- Read by premake5 as it is, and by Debian's premake4 through premake4.lua.

workspace "dragmesh"
    configurations { "release", "debug", "asan", "tsan" }
    location "build/make"
    cdialect "C17"
    cppdialect "C++17"
    warnings "Extra"
    buildoptions { "-Wpedantic", "-Wconversion", "-Wno-sign-conversion", "-ffp-contract=off", "-fno-math-errno", "-fno-trapping-math" }
    -- clang 19 warns of 0.5 * WIDTH where an enum without a name holds WIDTH; in C that is an int, and the product exact.
    buildoptions { "-Wno-enum-float-conversion" }
    fatalwarnings { "All" }
    visibility "Hidden"
    pic "On"
    symbols "On"
    defines { "_GNU_SOURCE" }

    filter "configurations:release"
        optimize "Speed"
        defines { "NDEBUG" }
    filter "configurations:debug"
        optimize "Off"
    filter "configurations:asan"
        optimize "On"
        sanitize { "Address", "UndefinedBehavior" }
        buildoptions { "-fno-sanitize-recover=undefined", "-fno-omit-frame-pointer" }
        linkoptions { "-fno-sanitize-recover=undefined" }
    filter "configurations:tsan"
        optimize "On"
        sanitize { "Thread" }
    filter {}

local embree = os.isfile("/usr/include/embree4/rtcore.h") and "embree4" or "embree3"

-- A program or library: its folders of sources, what it links, where its result goes.
local function make(name, kind_, sources, libraries)
    project(name)
        kind(kind_)
        language "C"
        files(sources)
        includedirs { "plugin_api/include", "sdk", "training/generator", "tests/include", "samples/dragmesh_cli" }
        objdir("build/obj/" .. name)
        if #libraries > 0 then links(libraries) end
end

local function library(name, sources, libraries)
    make(name, "StaticLib", sources, libraries)
        targetdir "build/%{cfg.buildcfg}/lib"
end

local function shared(name, sources, libraries, map)
    make(name, "SharedLib", sources, libraries)
        targetdir "build/%{cfg.buildcfg}"
        linkoptions { "-Wl,--version-script=../../" .. map, "-Wl,-z,defs", "-Wl,--gc-sections" }
        filter "configurations:asan or tsan"
            linkoptions { "-Wl,-z,undefs" }
        filter {}
end

local function program(name, sources, libraries, folder)
    make(name, "ConsoleApp", sources, libraries)
        targetdir("build/%{cfg.buildcfg}" .. (folder or ""))
        linkoptions { "-Wl,-rpath,'$$ORIGIN',-rpath,'$$ORIGIN/..'" }
end

-- Libraries --------------------------------------------------------------------------------------------------------

-- The whole library for static linking, C alone.
library("dragmesh_core", {
    "sdk/base/*.c", "sdk/math/*.c", "sdk/mesh/*.c", "sdk/pick/*.c", "sdk/nn/*.c", "sdk/kinematics/*.c",
    "sdk/motion/*.c", "plugin_api/src/*.c" }, {})

local core = { "dragmesh_core", "cjson", embree, "m" }

shared("dragmesh", { "plugin_api/src/interface.c" }, core, "plugin_api/dragmesh.map")

-- glTF in and out: the one room with C++ (tinygltf behind a thin C file).
shared("dragmesh_gltf", { "sdk/mesh/gltf/*.c", "sdk/mesh/gltf/*.cpp" },
    { "dragmesh_core", "tinygltf", "cjson", "m" }, "plugin_api/dragmesh_gltf.map")
    language "C++"

-- The procedural generator, and the library through which training sees the sdk's own samplers.
library("dragmesh_generator", { "training/generator/*.c" }, {})

shared("dragmesh_lab", { "training/lab/*.c" },
    { "dragmesh_generator", "dragmesh_core", "cjson", embree, "m" }, "training/lab/lab.map")

-- Programs ---------------------------------------------------------------------------------------------------------

program("dragmesh_cli", { "samples/dragmesh_cli/*.c" }, { "dragmesh", "dragmesh_gltf", "cjson", "png", "m" })
    targetname "dragmesh"

program("dragmesh_generate", { "training/generate/*.c" },
    { "dragmesh_generator", "dragmesh_gltf", "dragmesh", "cjson", "png", "m" })

-- What samples link beside the library; one whose library is missing is left out (scripts/install viewer).
local function installed(header)
    for _, folder in ipairs { "", "x86_64-linux-gnu/", "aarch64-linux-gnu/" } do
        if os.isfile("/usr/include/" .. folder .. header) then return true end
    end
    return false
end
local has_viewer = installed "SDL2/SDL.h" and installed "epoxy/gl.h"
local needs = {
    dynamic_load = { "dl" },
    host_memory_and_jobs = { "dragmesh", "pthread", "m" },
    prepare_offline = { "dragmesh", "dragmesh_gltf", "m" },
    gpu_skinning = { "dragmesh", "SDL2", "epoxy", "m" },
    vlm_intent = { "dragmesh", "curl", "cjson", "m" },
}
local missing = { viewer = true, gpu_skinning = not has_viewer, vlm_intent = not installed "curl/curl.h" }

for _, source in ipairs(os.matchfiles("samples/**main.c")) do
    local name = source:match("samples/%d+_([%w_]+)/main.c")
    if name and not missing[name] then
        program("sample_" .. name, { source }, needs[name] or { "dragmesh", "m" }, "/samples")
    end
end

if has_viewer then
    program("dragmesh_viewer", { "samples/10_viewer/*.c" },
        { "dragmesh", "dragmesh_gltf", "SDL2", "epoxy", "png", "z", "m" })
end

-- Tests: one program a file ------------------------------------------------------------------------------------------

for _, room in ipairs { "unit", "golden", "e2e", "abi" } do
    for _, source in ipairs(os.matchfiles("tests/" .. room .. "/test_*.c")) do
        local name = source:match("([%w_]+)%.c$")
        local libraries = { "cmocka", "dragmesh_gltf", "dragmesh_generator", "dragmesh_core", "cjson", embree, "dl", "m" }
        if room == "abi" or room == "e2e" then
            libraries = { "cmocka", "dragmesh", "dragmesh_gltf", "dragmesh_generator", "cjson", "png", "dl", "m" }
        end
        program(name, { source }, libraries, "/tests")
            if room ~= "abi" then defines { "DM_TEST_ROOM=\"" .. room .. "\"" } end
    end
end

for _, source in ipairs(os.matchfiles("tests/fuzz/fuzz_*.c")) do
    program(source:match("([%w_]+)%.c$"), { source, "tests/fuzz/driver.c" },
        { "dragmesh_gltf", "dragmesh_core", "cjson", embree, "m" }, "/fuzz")
end

for _, source in ipairs(os.matchfiles("tests/bench/bench_*.c")) do
    program(source:match("([%w_]+)%.c$"), { source, "tests/bench/support.c", "tests/bench/world.c" }, { "dragmesh_core", "cjson", embree, "m" }, "/bench")
end

// Untested: written from Unreal's documentation, and not built with the engine.
using System.IO;
using UnrealBuildTool;

public class DragMesh : ModuleRules
{
    public DragMesh(ReadOnlyTargetRules Target) : base(Target)
    {
        PCHUsage = PCHUsageMode.UseExplicitOrSharedPCHs;
        CppStandard = CppStandardVersion.Cpp17;
        PublicDependencyModuleNames.AddRange(new[] { "Core", "CoreUObject", "Engine" });

        string library = Path.Combine(PluginDirectory, "ThirdParty", "dragmesh");
        PublicSystemIncludePaths.Add(Path.Combine(library, "include"));
        if (Target.Platform == UnrealTargetPlatform.Win64)
        {
            PublicAdditionalLibraries.Add(Path.Combine(library, "lib", "dragmesh.lib"));
            PublicDelayLoadDLLs.Add("dragmesh.dll");
            RuntimeDependencies.Add("$(TargetOutputDir)/dragmesh.dll", Path.Combine(library, "bin", "dragmesh.dll"));
        }
        else if (Target.Platform == UnrealTargetPlatform.Linux)
        {
            string file = Path.Combine(library, "lib", "libdragmesh.so.0");
            PublicAdditionalLibraries.Add(file);
            PublicRuntimeLibraryPaths.Add(Path.GetDirectoryName(file));
            RuntimeDependencies.Add(file);
        }
    }
}

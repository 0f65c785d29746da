// Untested: written from Unreal's documentation, and not compiled with the engine.
#include "OpenableComponent.h"

#include "GameFramework/Actor.h"
#include "Modules/ModuleManager.h"

IMPLEMENT_MODULE(FDefaultModuleImpl, DragMesh)

static dm_vec3 From(const FVector& v) {
    return {float(v.X), float(v.Y), float(v.Z)};
}

UOpenableComponent::UOpenableComponent() {
    PrimaryComponentTick.bCanEverTick = true;
}

void UOpenableComponent::BeginPlay() {
    Super::BeginPlay();
    auto context = dragmesh_unreal::create_context();
    if (!context) return;
    Context = std::move(*context);
    auto parts = dragmesh_unreal::openable_parts::load(Context, {Prepared.GetData(), std::size_t(Prepared.Num())});
    if (!parts) {
        UE_LOG(LogTemp, Error, TEXT("dragmesh: %s: %s"), *GetOwner()->GetName(), UTF8_TO_TCHAR(parts.what()));
        return;
    }
    Parts = std::move(*parts);
    const FTransform Root = GetOwner()->GetActorTransform();
    for (std::size_t i = 0; i < Parts.count(); i++) {
        USceneComponent* Found = nullptr;
        for (UActorComponent* Component : GetOwner()->GetComponents())
            if (PartComponents.IsValidIndex(int32(i)) && Component->GetFName() == PartComponents[int32(i)])
                Found = Cast<USceneComponent>(Component);
        Moving.Add(Found);
        AtRest.Add(Found ? Found->GetComponentTransform().GetRelativeTransform(Root) : FTransform::Identity);
    }
}

void UOpenableComponent::EndPlay(EEndPlayReason::Type Reason) {
    Parts = {};
    Context = {};
    Moving.Empty();
    AtRest.Empty();
    Held = INDEX_NONE;
    Super::EndPlay(Reason);
}

bool UOpenableComponent::Grab(USceneComponent* Component, FVector Point) {
    const int32 Part = Moving.Find(Component);
    if (Component == nullptr || Part == INDEX_NONE) return false;
    if (!Parts.grab(Part, From(GetOwner()->GetActorTransform().InverseTransformPosition(Point)))) return false;
    Held = Part;
    return true;
}

void UOpenableComponent::Pull(FVector Origin, FVector Direction, float Seconds) {
    if (Held == INDEX_NONE) return;
    const FTransform Root = GetOwner()->GetActorTransform();
    Parts.pull(Held, {From(Root.InverseTransformPosition(Origin)), From(Root.InverseTransformVector(Direction))},
               Seconds);
    Moved.Broadcast(Held, Parts.state(Held).value);
    Show();
}

void UOpenableComponent::Release() {
    if (Held != INDEX_NONE) Parts.release(Held);
    Held = INDEX_NONE;
}

void UOpenableComponent::TickComponent(float Seconds, ELevelTick Tick, FActorComponentTickFunction* Function) {
    Super::TickComponent(Seconds, Tick, Function);
    Parts.advance(Seconds);
    Show();
}

void UOpenableComponent::Show() {
    const FTransform Root = GetOwner()->GetActorTransform();
    for (int32 i = 0; i < Moving.Num(); i++) {
        if (Moving[i] == nullptr) continue;
        const dragmesh_unreal::placement Now = Parts.at(i);
        const FTransform Pose(FQuat(Now.rotation[0], Now.rotation[1], Now.rotation[2], Now.rotation[3]),
                              FVector(Now.translation.x, Now.translation.y, Now.translation.z));
        Moving[i]->SetWorldTransform(AtRest[i] * Pose * Root); // Unreal's order: the left one first
    }
}

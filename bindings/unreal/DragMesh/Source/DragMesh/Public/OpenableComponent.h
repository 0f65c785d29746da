// Untested: written from Unreal's documentation, and not compiled with the engine.
#pragma once

#include "Components/ActorComponent.h"
#include "CoreMinimal.h"

#include "OpenableParts.h"

#include "OpenableComponent.generated.h"

DECLARE_DYNAMIC_MULTICAST_DELEGATE_TwoParams(FOpenableMoved, int32, Part, float, Value);

/** Moves the actor's components by a prepared object. Its object frame is that of the actor's root. */
UCLASS(ClassGroup = (DragMesh), meta = (BlueprintSpawnableComponent))
class DRAGMESH_API UOpenableComponent : public UActorComponent {
    GENERATED_BODY()

  public:
    UOpenableComponent();

    /** The bytes of a .dmo, as `dragmesh prepare` writes it. */
    UPROPERTY(EditAnywhere, Category = "DragMesh")
    TArray<uint8> Prepared;

    /** The components of the parts, in the order of their ids. */
    UPROPERTY(EditAnywhere, Category = "DragMesh")
    TArray<FName> PartComponents;

    /** Follows every part that a player moves. */
    UPROPERTY(BlueprintAssignable, Category = "DragMesh")
    FOpenableMoved Moved;

    /** Grabs the part that a component is, at a point of the world. */
    UFUNCTION(BlueprintCallable, Category = "DragMesh")
    bool Grab(USceneComponent* Component, FVector Point);

    /** The grabbed point follows a ray of the world; every frame. */
    UFUNCTION(BlueprintCallable, Category = "DragMesh")
    void Pull(FVector Origin, FVector Direction, float Seconds);

    UFUNCTION(BlueprintCallable, Category = "DragMesh")
    void Release();

    void BeginPlay() override;
    void EndPlay(EEndPlayReason::Type Reason) override;
    void TickComponent(float Seconds, ELevelTick Tick, FActorComponentTickFunction* Function) override;

  private:
    void Show();

    dragmesh::context Context;
    dragmesh_unreal::openable_parts Parts;
    TArray<USceneComponent*> Moving;
    TArray<FTransform> AtRest; // relative to the root
    int32 Held = INDEX_NONE;
};

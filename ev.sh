cd /work/out/fin; export DRAGMESH_MODELS=/work/main/sdk/models
D=/work/shared/articulated/dev; P=/work/shared/articulated/props
i=0; e() { echo "=== $*"; ./dragmesh eval "$@"; }
{ e $D; e $D --turn 1; e $D --turn 2; e $D --turn 3; e $D --turn 4; e $D --drag-noise 8; e $D --drag-noise 8 --drags 3; e $D --pull chord; e $D --pull axis; e $D --mask-noise 0.1; e $D --no-drag; e $P; e $P --drag-noise 8; e $P --pull chord; e $P --pull axis; e $P --no-drag; e $D --moving auto; e $D --moving auto --merge; } > ev.txt 2>&1; date >> ev.txt

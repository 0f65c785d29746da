cd /work/out/fin; export DRAGMESH_MODELS=/work/main/sdk/models
for s in props dev; do ./dragmesh dragbot /work/shared/articulated/$s --all --cameras 4 --json > all_$s.json 2> all_$s.err; done; date > done

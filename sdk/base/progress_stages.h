/* Stages of progress: for each job that takes long, the share of it that is done when a stage of it is over. A job may
 * be a stage of another one, by whose shares its own are scaled (dmi_progress_piece). The host's callback hears of the
 * whole call. Shares that follow from counts, of faces or of parts, stand where these are counted. */
#ifndef DMI_BASE_PROGRESS_STAGES_H
#define DMI_BASE_PROGRESS_STAGES_H

/* ---- dm_object_prepare ---- */

#define DMI_STAGE_PREPARE_MESH_READ 0.05f  /* the mesh is checked; by hand */
#define DMI_STAGE_PREPARE_PACKED 0.055f    /* its triangles are packed; measured */
#define DMI_STAGE_PREPARE_TREES_BUILT 0.1f /* the trees for picking are built; by hand */
#define DMI_STAGE_PREPARE_SHARED 0.12f     /* what the parts share is made; the rest is the parts */

/* ---- dm_object_refine ---- */

#define DMI_STAGE_REFINE_UNPACKED 0.1f /* the mesh is computed again; by hand */
#define DMI_STAGE_REFINE_SHARED 0.5f   /* the vertices are welded and the part masks repaired; by hand */

/* ---- what parts share of a mesh ---- */

#define DMI_STAGE_SHARE_WELDED 0.5f /* the vertices are welded; measured */

/* ---- one part ---- */

#define DMI_STAGE_PART_SAMPLED 0.1f /* the part is sampled; measured */

/* ---- the inference of its joint ---- */

#define DMI_STAGE_INFER_ANALYSED 0.3f    /* the part is analysed; measured */
#define DMI_STAGE_INFER_NETWORK_RUN 0.6f /* KPP-Net has run; measured */
#define DMI_STAGE_INFER_RANKED 0.9f      /* the candidates are ranked; measured */

/* ---- the analysis of a part ---- */

#define DMI_STAGE_ANALYSE_VERTICES_TAKEN 0.3f /* the part's vertices are collected; measured */
#define DMI_STAGE_ANALYSE_MEASURED 0.6f       /* all but its patches is measured; measured */

/* ---- dm_object_load ---- */

#define DMI_STAGE_LOAD_CHECKED 0.05f        /* the checksum is right; measured */
#define DMI_STAGE_LOAD_ARRAYS_READ 0.1f     /* the arrays of triangles are copied; measured */
#define DMI_STAGE_LOAD_TRIANGLES_READ 0.25f /* the triangles are packed; measured */

/* ---- dm_asset_create ---- */

#define DMI_STAGE_ASSET_MERGED 0.05f /* the meshes of the nodes are merged; by hand */

/* ---- the rest of it ---- */

#define DMI_STAGE_BODIES_MESH_MEASURED 0.05f /* the mesh of the nodes is measured; by hand */
#define DMI_STAGE_BODIES_KNOWN 0.15f         /* the bodies are known; by hand */
#define DMI_STAGE_BODIES_JOINTS_KNOWN 0.95f  /* their joints are; by hand */

/* ---- the choice of the bodies ---- */

#define DMI_STAGE_GROUP_CELLS_FILLED 0.2f /* the nodes are rasterised; by hand */
#define DMI_STAGE_GROUP_PAIRS_RATED 0.5f  /* their pairs are rated; by hand */

/* ---- dm_mesh_find_part ---- */

#define DMI_STAGE_FIND_MESH_READ 0.15f /* the mesh is checked; measured */

/* ---- the search in it ---- */

#define DMI_STAGE_SEARCH_FACE_FOUND 0.05f /* the grabbed face is found; measured */
#define DMI_STAGE_SEARCH_DIVIDED 0.5f     /* the mesh is divided; measured */
#define DMI_STAGE_SEARCH_PROPOSED 0.97f   /* the proposals are made; measured */

/* ---- the sheets of a mesh ---- */

#define DMI_STAGE_SHEETS_WELDED 0.3f /* the vertices are welded; measured */
#define DMI_STAGE_SHEETS_FOUND 0.8f  /* the sheets are found; measured */

/* ---- one level of pieces ---- */

#define DMI_STAGE_LEVEL_SHEET_CUT 0.5f /* the sheet is cut; measured */
#define DMI_STAGE_LEVEL_SAMPLED 0.8f   /* the pieces have their samples; measured */

/* ---- the proposals, two levels of which are made and grown ---- */

#define DMI_STAGE_PROPOSE_WHOLE_MADE 0.3f  /* the level of whole sheets is made; by hand */
#define DMI_STAGE_PROPOSE_WHOLE_GROWN 0.4f /* its region is grown; by hand */
#define DMI_STAGE_PROPOSE_CUT_MADE 0.8f    /* the level of the cut sheet is made; by hand */
#define DMI_STAGE_PROPOSE_CUT_GROWN 0.9f   /* its region is grown; by hand */

/* ---- measuring a mesh ---- */

#define DMI_STAGE_MEASURE_FACES_DONE 0.7f /* the faces have areas and normals; measured */

/* ---- regions of faces ---- */

#define DMI_STAGE_REGIONS_EDGES_COUNTED 0.2f /* the edges are counted; measured */
#define DMI_STAGE_REGIONS_EDGES_SORTED 0.6f  /* they are sorted; measured */

/* ---- the repair of a part mask ---- */

#define DMI_STAGE_REPAIR_FIRST_VOTE 0.5f /* the first of two votes is over; by hand */

/* ---- dm_gltf_open ---- */

#define DMI_STAGE_GLTF_PARSED 0.2f       /* the JSON is parsed; by hand */
#define DMI_STAGE_GLTF_BUFFERS_READ 0.3f /* the buffers are there; by hand */
#define DMI_STAGE_GLTF_TREE_READ 0.35f   /* the tree of nodes is read; by hand */
#define DMI_STAGE_GLTF_SHAPES_BUILT 0.8f /* the shapes are built, which are placed in the rest; by hand */

/* ---- dm_gltf_export ---- */

#define DMI_STAGE_EXPORT_OPENED 0.1f       /* the faces of the tracks are known; by hand */
#define DMI_STAGE_EXPORT_TRACKS_ADDED 0.2f /* the tracks have their animations; by hand */
#define DMI_STAGE_EXPORT_PARTS_MOVED 0.5f  /* what moves has its triangles; by hand */
#define DMI_STAGE_EXPORT_LISTS_MENDED 0.7f /* what stays has its triangles; by hand */

#endif

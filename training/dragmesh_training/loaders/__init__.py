"""Data sets of articulated objects: URDF folders in, object.glb + joints.json out, and those as training examples."""

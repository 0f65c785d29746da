"""Prepares every glTF file of a folder: python3 -m dragmesh.batch FOLDER. See __main__.py."""

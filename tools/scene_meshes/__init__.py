"""The meshes of the example scenes, each in a file of its own."""

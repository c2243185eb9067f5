"""Parts of tools/make_jacksboro.py: the terrain, the village and the forest of a demo place."""

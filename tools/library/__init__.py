"""How the files of scenes/library/ are made; tools/make_library.py is the command."""

"""Parts of tools/make_showcase.py."""

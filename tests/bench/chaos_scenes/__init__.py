"""The parts of chaos.py: the judge, the server under test, the lines with their scenes, and what disturbs them."""

"""run_blocks.py PAGE LEAST: runs the ```python blocks of a page, at least so many, one after the other, in a folder of their own."""
import os
import re
import sys
import tempfile

with open(sys.argv[1], encoding="utf-8") as file:
    page = file.read()
blocks = re.findall(r"^```python\n(.*?)^```$", page, re.S | re.M)
assert len(blocks) >= int(sys.argv[2]), f"{sys.argv[1]} has only {len(blocks)} python blocks"
names = {}
with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    for k, block in enumerate(blocks, 1):
        exec(compile(block, f"{os.path.basename(sys.argv[1])}, block {k}", "exec"), names)
    written = set(os.listdir("."))
    os.chdir("/")
for name in set(re.findall(r'"([a-z]+\.(?:epsn|json|svg|html|msh|mtx|tsv|txt|vtu))"', "".join(blocks))):
    assert name in written, f"{name} was not written"

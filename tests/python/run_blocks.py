"""run_blocks.py PAGE EPSNET CERTIFY: runs the ```python blocks of a page, one after the other, beside a net and its mesh."""
import os
import re
import subprocess
import sys
import tempfile

page, epsnet, certify = sys.argv[1:]
blocks = re.findall(r"^```python\n(.*?)^```$", open(page, encoding="utf-8").read(), re.S | re.M)
assert blocks, f"{page} has no python block"
makers = [["octagon", "--seed", "123"], ["fenchel-nielsen", "--genus", "3", "--seed", "5"]]
for maker in makers:
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        run = lambda *arguments: subprocess.run(arguments, check=True, stdout=subprocess.DEVNULL)
        run(epsnet, "surface", *maker, "-o", "s.json")
        run(epsnet, "net", "s.json", "--epsilon", "0.25", "-o", "net.json")
        run(certify, "net.json")
        run(epsnet, "export", "net.json", "--format", "json", "-o", "mesh.json")
        names = {}
        for k, block in enumerate(blocks, 1):
            exec(compile(block, f"{os.path.basename(page)}, block {k}", "exec"), names)
        os.chdir("/")

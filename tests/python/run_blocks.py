"""run_blocks.py PAGE EPSNET CERTIFY: runs the ```python blocks of a page, one after the other, beside a net and its mesh."""
import os
import re
import subprocess
import sys
import tempfile

page, epsnet, certify = sys.argv[1:]
blocks = re.findall(r"^```python\n(.*?)^```$", open(page, encoding="utf-8").read(), re.S | re.M)
assert blocks, f"{page} has no python block"
cases = [  # The surface, epsilon, the least number of vertices.
    (["octagon", "--seed", "123"], "0.25", 100),
    (["fenchel-nielsen", "--genus", "3", "--seed", "5"], "0.25", 200),
    (["regular", "--genus", "2"], "0.25", 100),
    (["regular", "--genus", "5"], "0.25", 400),
    (["octagon", "--seed", "123"], "0.034", 7000),  # Nothing may take the square of the number of vertices, let alone its cube.
]
for maker, epsilon, least in cases:
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        run = lambda *arguments: subprocess.run(arguments, check=True, stdout=subprocess.DEVNULL)
        run(epsnet, "surface", *maker, "-o", "s.json")
        run(epsnet, "net", "s.json", "--epsilon", epsilon, "-o", "net.json")
        run(certify, "net.json")
        run(epsnet, "export", "net.json", "--format", "json", "-o", "mesh.json")
        names = {}
        for k, block in enumerate(blocks, 1):
            exec(compile(block, f"{os.path.basename(page)}, block {k}", "exec"), names)
        assert len(names["vertices"]) >= least, f"{' '.join(maker)}: only {len(names['vertices'])} vertices"
        # The paths are shortest: no edge makes one shorter, and every vertex but the first is reached along an edge.
        far, u, v, length = (names[name] for name in ("far", "u", "v", "length"))
        assert far[0] == 0 and (far[u] + length >= far[v]).all() and (far[v] + length >= far[u]).all()
        reached = {0, *v[far[u] + length == far[v]].tolist(), *u[far[v] + length == far[u]].tolist()}
        assert len(reached) == len(far)
        os.chdir("/")

# Lemma 28 of docs/proof.md: filter::delaunay in certify/net/filter.cpp, line by line.
# Names in capitals are exact. A, B, C, D are differences of points that are given exactly; each is scaled by a power of
# two, so that the norm of the rounded difference is in [1, 2].
@fl = float<ieee_64, ne>;

ax = fl(AX);  ay = fl(AY);   # minus(z3, z1)
bx = fl(BX);  by = fl(BY);   # minus(z2, z0)
cx = fl(CX);  cy = fl(CY);   # minus(z3, z0)
dx = fl(DX);  dy = fl(DY);   # minus(z2, z1)

nx fl= ax * bx - ay * by;    # times(a, b)
ny fl= ax * by + ay * bx;
mx fl= cx * dx - cy * dy;    # times(c, d)
my fl= cx * dy + cy * dx;
value fl= mx * ny - my * nx; # cross(times(c, d), times(a, b))

NX = AX * BX - AY * BY;
NY = AX * BY + AY * BX;
MX = CX * DX - CY * DY;
MY = CX * DY + CY * DX;
VALUE = MX * NY - MY * NX;

# The norms, and what the value is compared with.
bound fl= -1b-16 * ((na * nb) * (nc * nd));

{ |ax| <= 2 /\ |ay| <= 2 /\ |bx| <= 2 /\ |by| <= 2 /\ |cx| <= 2 /\ |cy| <= 2 /\ |dx| <= 2 /\ |dy| <= 2 /\
  na in [1, 2] /\ nb in [1, 2] /\ nc in [1, 2] /\ nd in [1, 2]
  -> |value - VALUE| <= 1b-42 /\ bound <= -1b-16 }

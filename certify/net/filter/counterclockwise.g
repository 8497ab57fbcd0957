# Lemma 27 of docs/proof.md: filter::counterclockwise in certify/net/filter.cpp, line by line.
# Names in capitals are exact. S and V are differences of points that are given exactly; each is scaled by a power of two,
# so that the norm of the rounded difference is in [1, 2]. (P, Q), (P1, Q1), (P2, Q2) are z0, z1, z2.
@fl = float<ieee_64, ne>;

sx = fl(SX);  sy = fl(SY);   # minus(z1, z0)
vx = fl(VX);  vy = fl(VY);   # minus(z2, z0)
f fl= sx * (p + p1) + sy * (q + q1);
g fl= vx * (p + p2) + vy * (q + q2);
middle fl= (1 + (p * p + q * q)) * (sx * vy - sy * vx);
determinant fl= (middle + p * (sy * g - vy * f)) - q * (sx * g - vx * f);
bound fl= 1b-23 * (ns * nv); # the norms, what the determinant is compared with

F = SX * (p + p1) + SY * (q + q1);
G = VX * (p + p2) + VY * (q + q2);
DETERMINANT = ((1 + (p * p + q * q)) * (SX * VY - SY * VX) + p * (SY * G - VY * F)) - q * (SX * G - VX * F);

{ |sx| <= 2 /\ |sy| <= 2 /\ |vx| <= 2 /\ |vy| <= 2 /\ |p| <= 1 /\ |q| <= 1 /\ |p1| <= 1 /\ |q1| <= 1 /\ |p2| <= 1 /\ |q2| <= 1 /\
  ns in [1, 2] /\ nv in [1, 2]
  -> |determinant - DETERMINANT| <= 1b-43 /\ bound >= 1b-23 }

# Lemma 30 of docs/proof.md: filter::squared_sinh_of_circumradius in certify/net/filter.cpp. Names in capitals are exact.
# The squared distances are scaled by a power of two, not less than 1/4, so that the greatest of x, y, z is in [1, 2].
@fl = float<ieee_64, ne>;

d0 = fl(dd0);  d1 = fl(dd1);  d2 = fl(dd2);  a0 = fl(aa0);  a1 = fl(aa1);  a2 = fl(aa2);  greatest = fl(gg);
x fl= d0 * a2;
y fl= d1 * a0;
z fl= d2 * a1;
w fl= x + y - z;
k fl= 4 * (x * y) - w * w;
error fl= 1b-29 * (greatest * greatest);

X = D0 * A2;
Y = D1 * A0;
Z = D2 * A1;
K = 4 * (X * Y) - (X + Y - Z) * (X + Y - Z);

{ x in [1b-214, 2] /\ y in [1b-214, 2] /\ z in [1b-214, 2] /\ greatest in [1, 2] /\
  |d0 -/ D0| <= 1b-46 /\ |d1 -/ D1| <= 1b-46 /\ |d2 -/ D2| <= 1b-46 /\
  |a0 -/ A0| <= 1b-38 /\ |a1 -/ A1| <= 1b-38 /\ |a2 -/ A2| <= 1b-38
  -> |x -/ X| <= 1b-37 /\ |y -/ Y| <= 1b-37 /\ |z -/ Z| <= 1b-37 /\ |k - K| <= 1b-30 /\ error >= 1b-29 }

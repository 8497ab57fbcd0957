# Lemma 30 of docs/proof.md: filter::squared_sinh_of_circumradius in certify/filter.cpp. Names in capitals are exact.
# The three products are scaled by a power of two, so that the greatest is at least 1 and less than 2.
@fl = float<ieee_64, ne>;

x = fl(xx);  y = fl(yy);  z = fl(zz);
w fl= x + y - z;
k fl= 4 * (x * y) - w * w;

K = 4 * (X * Y) - (X + Y - Z) * (X + Y - Z);

{ x in [0, 2] /\ y in [0, 2] /\ z in [0, 2] /\
  |x -/ X| <= 1b-37 /\ |y -/ Y| <= 1b-37 /\ |z -/ Z| <= 1b-37
  -> |k - K| <= 1b-30 }

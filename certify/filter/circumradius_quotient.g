# Lemma 30 of docs/proof.md: the quotients in filter::squared_sinh_of_circumradius in certify/filter.cpp, for k and its
# error as computed. Names in capitals are exact.
@fl = float<ieee_64, ne>;

d0 = fl(dd0);  d1 = fl(dd1);  d2 = fl(dd2);  k = fl(kk);  e = fl(ee);
numerator fl= 4 * ((d0 * d1) * d2);
lower fl= numerator / (k + e);
upper fl= numerator / (k - e);

LOWER = 4 * ((D0 * D1) * D2) / (k + e);
UPPER = 4 * ((D0 * D1) * D2) / (k - e);

{ d0 in [1b-200, 8] /\ d1 in [1b-200, 8] /\ d2 in [1b-200, 8] /\
  |d0 -/ D0| <= 1b-46 /\ |d1 -/ D1| <= 1b-46 /\ |d2 -/ D2| <= 1b-46 /\
  k + e in [1b-436, 1b10] /\ k - e in [1b-436, 1b10]
  -> |lower -/ LOWER| <= 1b-40 /\ |upper -/ UPPER| <= 1b-40 }

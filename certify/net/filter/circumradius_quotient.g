# Lemma 30 of docs/proof.md: the quotients in filter::squared_sinh_of_circumradius in certify/net/filter.cpp, for k and its
# error as computed. Names in capitals are exact.
@fl = float<ieee_64, ne>;

d0 = fl(dd0);  d1 = fl(dd1);  d2 = fl(dd2);  k = fl(kk);  error = fl(ee);
narrower = 1 - 1b-30;
wider = 1 + 1b-30;
numerator fl= 4 * ((d0 * d1) * d2);
least fl= numerator / (k + error);
most fl= numerator / (k - error);
lower fl= numerator / (k + error) * narrower;
upper fl= numerator / (k - error) * wider;

LEAST = 4 * ((D0 * D1) * D2) / (k + error);
MOST = 4 * ((D0 * D1) * D2) / (k - error);

{ d0 in [1b-200, 8] /\ d1 in [1b-200, 8] /\ d2 in [1b-200, 8] /\
  |d0 -/ D0| <= 1b-46 /\ |d1 -/ D1| <= 1b-46 /\ |d2 -/ D2| <= 1b-46 /\
  k + error in [1b-436, 1b10] /\ k - error in [1b-436, 1b10]
  -> |least -/ LEAST| <= 1b-40 /\ |most -/ MOST| <= 1b-40 /\ lower / LEAST <= 1 /\ upper / MOST >= 1 }

# How the errors of the last two come about: identities, which Gappa checks.
lower / LEAST ->
  narrower * (1 + (lower - least * narrower) / (least * narrower)) * (1 + (least - LEAST) / LEAST)
  { least <> 0, LEAST <> 0 };
upper / MOST ->
  wider * (1 + (upper - most * wider) / (most * wider)) * (1 + (most - MOST) / MOST)
  { most <> 0, MOST <> 0 };

# Lemma 29 of docs/proof.md: filter::squared_distance in certify/net/filter.cpp. Names in capitals are exact.
# S is the difference of two points that are given exactly, scaled by a power of two, so that the norm of the rounded
# difference is in [1, 2]; it is the norm of the first coordinate, or the two are exchanged.
@fl = float<ieee_64, ne>;

sx = fl(SX);  sy = fl(SY);
squared fl= sx * sx + sy * sy;

SQUARED = SX * SX + SY * SY;

{ |sx| in [1, 2] /\ |sy| <= 2 -> |squared - SQUARED| <= 1b-47 /\ |squared -/ SQUARED| <= 1b-46 }

# Lemma 29 of docs/proof.md: filter::gap in certify/net/filter.cpp, for a point (p, q). Names in capitals are exact.
@fl = float<ieee_64, ne>;

gap fl= 1 - (p * p + q * q);

GAP = 1 - (p * p + q * q);

{ |p| <= 1 /\ |q| <= 1 -> |gap - GAP| <= 1b-51 /\ (gap >= 1b-12 -> |gap -/ GAP| <= 1b-38) }

# Lemma 29 of docs/proof.md: the quotient in filter::squared_half_sinh in certify/filter.cpp. Names in capitals are exact.
@fl = float<ieee_64, ne>;

d = fl(dd);  a = fl(aa);  b = fl(bb);
quotient fl= d / (a * b);

QUOTIENT = D / (A * B);

{ d in [1b-200, 8] /\ a in [1b-12, 1] /\ b in [1b-12, 1] /\
  |d -/ D| <= 1b-46 /\ |a -/ A| <= 1b-38 /\ |b -/ B| <= 1b-38
  -> |quotient -/ QUOTIENT| <= 1b-36 }

# Lemma 29 of docs/proof.md: filter::squared_half_sinh in certify/net/filter.cpp. Names in capitals are exact.
@fl = float<ieee_64, ne>;

d = fl(dd);  a = fl(aa);  b = fl(bb);
narrower = 1 - 1b-30;
wider = 1 + 1b-30;
quotient fl= d / (a * b);
lower fl= quotient * narrower;
upper fl= quotient * wider;

QUOTIENT = D / (A * B);

{ d in [1b-200, 8] /\ a in [1b-12, 1] /\ b in [1b-12, 1] /\
  |d -/ D| <= 1b-46 /\ |a -/ A| <= 1b-38 /\ |b -/ B| <= 1b-38
  -> |quotient -/ QUOTIENT| <= 1b-36 /\ lower / QUOTIENT <= 1 /\ upper / QUOTIENT >= 1 }

# How the errors of the last two come about: identities, which Gappa checks.
lower / QUOTIENT ->
  narrower * (1 + (lower - quotient * narrower) / (quotient * narrower)) * (1 + (quotient - QUOTIENT) / QUOTIENT)
  { quotient <> 0, QUOTIENT <> 0 };
upper / QUOTIENT ->
  wider * (1 + (upper - quotient * wider) / (quotient * wider)) * (1 + (quotient - QUOTIENT) / QUOTIENT)
  { quotient <> 0, QUOTIENT <> 0 };

(** The program's checker. What the extraction maps to zarith is what it trusts: docs/formal.md. *)

From Coq Require Import ZArith.
From Coq Require Import ExtrOcamlBasic ExtrOcamlZBigInt.
From Epsnet Require Import Document Checker.

Extract Constant Z.gcd => "Big_int_Z.gcd_big_int".
Extract Constant Z.ltb => "Big_int_Z.lt_big_int".
Extract Constant Z.leb => "Big_int_Z.le_big_int".
Extract Constant N.eqb => "Big_int_Z.eq_big_int".
Extract Constant N.ltb => "Big_int_Z.lt_big_int".
Extract Constant N.leb => "Big_int_Z.le_big_int".

Extraction "checker.ml" decide check.

# Bound S, the discriminant: see book/notes/proofs.md. Lengths are counted in the larger of
# |oc| and r, directions in |d|. Then w, which is |d x oc|, and p, which is a.r.r, are at most
# 1; what is bounded is the whole error, where all its terms are as large as they can be.

# |d x oc|: its components are off by what Cauchy and Schwarz allow, and by u of themselves.
dw = k * 1b-53 + w * ew;
across = (w + dw) * (w + dw) * (1 + e1) * (1 + e2) * (1 + e3);
d_hat = (p * (1 + a1) * (1 + a2) * (1 + a3) * (1 + a4) * (1 + a5) - across) * (1 + e4);

{ w in [0, 1] /\ p in [0, 1] /\ k in [-2.83, 2.83]      # 2 sqrt 2
/\ ew in [-1b-53, 1b-53]
/\ e1 in [-1b-53, 1b-53] /\ e2 in [-1b-53, 1b-53] /\ e3 in [-1b-53, 1b-53]
/\ a1 in [-1b-53, 1b-53] /\ a2 in [-1b-53, 1b-53] /\ a3 in [-1b-53, 1b-53]
/\ a4 in [-1b-53, 1b-53] /\ a5 in [-1b-53, 1b-53] /\ e4 in [-1b-53, 1b-53]
->
   d_hat - (p - w * w) in [-17b-53, 17b-53] }  # 5.7 + 5 + 5, and 1 of the difference

d_hat - (p - w * w) ->
    p * ((1 + a1) * (1 + a2) * (1 + a3) * (1 + a4) * (1 + a5) - 1)
  - (2 * w * dw + dw * dw)
  - (w + dw) * (w + dw) * ((1 + e1) * (1 + e2) * (1 + e3) - 1)
  + (p * (1 + a1) * (1 + a2) * (1 + a3) * (1 + a4) * (1 + a5) - across) * e4;

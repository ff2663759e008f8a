# Bounds A and C, and of M: see book/notes/proofs.md.
#
# A rounded operation is its exact result times (1 + e) with |e| <= u = 2^-53.
# Lengths are counted in sqrt(M) and directions in |d|, so that M = 1 and a = 1.
# Then s = oc.oc is from 0 to 1, and r.r = 1 - s.

# d.d: all terms are positive, so the errors of each product and of the sums
# along its way bound the error of the whole.
a_hat = (1 + ea1) * (1 + ea2) * (1 + ea3);

# oc.oc: each component is rounded once before it is squared.
f = (1 + es1) * (1 + es1) * (1 + es2) * (1 + es3) * (1 + es4);
c_hat = (s * f - (1 - s) * (1 + er)) * (1 + ec);
m_hat = (s * f + (1 - s) * (1 + er)) * (1 + em);

{ ea1 in [-1b-53, 1b-53] /\ ea2 in [-1b-53, 1b-53] /\ ea3 in [-1b-53, 1b-53]
/\ es1 in [-1b-53, 1b-53] /\ es2 in [-1b-53, 1b-53] /\ es3 in [-1b-53, 1b-53]
/\ es4 in [-1b-53, 1b-53]
/\ er in [-1b-53, 1b-53] /\ ec in [-1b-53, 1b-53] /\ em in [-1b-53, 1b-53]
/\ s in [0, 1]
->
   a_hat - 1 in [-97b-58, 97b-58]   # 3u and a little
/\ c_hat - (s - (1 - s)) in [-15b-54, 15b-54]   # 7.5u
/\ m_hat - 1 in [-9b-53, 9b-53]
}

c_hat - (s - (1 - s)) ->
  s * (f - 1) - (1 - s) * er + (s * f - (1 - s) * (1 + er)) * ec;
m_hat - 1 ->
  s * (f - 1) + (1 - s) * er + (s * f + (1 - s) * (1 + er)) * em;

# Bound D: see book/notes/proofs.md. As in coefficients.g, M = 1 and a = 1.
# Here dh, da and dc are the errors of h, a and c. The Cauchy-Schwarz inequality
# makes |h| <= 1, and D = h^2 - c.

p = (h + dh) * (h + dh);
q = (1 + da) * (c + dc);
d_hat = (p * (1 + e1) - q * (1 + e2)) * (1 + e3);

{ dh in [-129b-58, 129b-58]         # 4u and a little
/\ da in [-97b-58, 97b-58]          # 3u and a little
/\ dc in [-15b-54, 15b-54]
/\ e1 in [-1b-53, 1b-53] /\ e2 in [-1b-53, 1b-53] /\ e3 in [-1b-53, 1b-53]
/\ h in [-1, 1] /\ c in [-1, 1]
->
   d_hat - (h * h - c) in [-47b-54, 47b-54] }  # 23.5u

d_hat - (h * h - c) ->
    (2 * h * dh + dh * dh) + p * e1
  - (da * c + dc + da * dc) - q * e2
  + (p * (1 + e1) - q * (1 + e2)) * e3;

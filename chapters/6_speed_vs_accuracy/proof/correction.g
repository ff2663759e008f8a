# Bound R, the step: see book/notes/proofs.md. M = 1 and a = 1. The root is tau, with
# s = tau - h; t is what bound T leaves, cut to 26 digits by et and ec. As
# F(t) = (t - tau) * g with g = (t - h) + s, a quotient without errors would find tau.

y = (1 + et) * (1 + ec) - 1;            # (t - tau) / tau
g = 2 * s_w + y * tau_w;                # g / w, the divisor
eg = (dn_w + ds_w) / g * (1 + e3) + e3;

# The error of the quotient F / g, and that of what is left of F, both over tau.
off = y * (1 - (1 + ef) * (1 + eq) / (1 + eg)) - df * per_w_tau / g * (1 + eq) / (1 + eg);

{ et in [-34b-38, 34b-38]               # bound T, as w * |t| > 2^-15
/\ ec in [-1b-25, 0]
/\ per_w_tau in [-32769, 32769]        # 1 / (w * tau): |t| * w > 2^-15
/\ tau_w in [-364, 364]                 # |tau| <= 1.42, times 2^8
/\ s_w in [0.999, 1.001]                # s / w, by bound D
/\ dn_w in [-3400b-53, 3400b-53]         # of t - h, over w: 13u, times 2^8 and a little
/\ ds_w in [-800000b-53, 800000b-53]     # of s, over w: 12u, times 2^16 and a little
/\ df in [-13b-74, 13b-74]              # residual.g
/\ ef in [-1b-53, 1b-53] /\ eq in [-1b-53, 1b-53] /\ e3 in [-1b-53, 1b-53]
->
   off in [-3b-57, 3b-57] }   # less than 0.19u


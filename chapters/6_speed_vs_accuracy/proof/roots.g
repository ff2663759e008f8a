# Bound T: see book/notes/proofs.md. As in coefficients.g, M = 1 and a = 1.
# Here s is the root of D, and w that of the computed D before it is rounded; dh, da and
# dc are the errors of h, a and c. Let h >= 0: otherwise all signs change.

q = h + s;
q_hat = (h + dh + w * (1 + ew)) * (1 + eq);
first_hat = q_hat / (1 + da) * (1 + e1);       # q / a
second_hat = (second * q + dc) / q_hat * (1 + e2);  # c / q

{ w * w - s * s in [-47b-54, 47b-54]    # bound D
/\ s / w in [0.7, 1.23]                 # since w * w > 48u
/\ q / q_hat in [0.7, 1.23]             # it lies between s / w and 1, but for rounding
/\ q / q_hat / (1 + s / w) in [0.4, 0.59]
/\ w / q_hat in [0, 1.001]              # q_hat is the sum of |h_hat| and w
/\ second / q in [-1, 1]                # the other root, q / a, is not nearer to 0
/\ w in [1b-24, 1.001]
/\ h in [0, 1] /\ s in [1b-25, 1]
/\ dh in [-129b-58, 129b-58]
/\ da in [-97b-58, 97b-58]
/\ dc in [-15b-54, 15b-54]
/\ ew in [-1b-53, 1b-53] /\ eq in [-1b-53, 1b-53]
/\ e1 in [-1b-53, 1b-53] /\ e2 in [-1b-53, 1b-53]
->
   (first_hat - q) * w in [-68b-54, 68b-54]
/\ (second_hat - second) * w in [-68b-54, 68b-54]   # 34u
}

(w - s) * w -> (w * w - s * s) / (1 + s / w) { w <> 0, 1 + s / w <> 0 };
(q_hat - q) * w ->
  ((w - s) * w + dh * w + ew * (w * w)) * (1 + eq) + q * eq * w;
(first_hat - q) * w ->
  ((q_hat - q) * w * (1 + e1) + q * w * (e1 - da)) / (1 + da) { 1 + da <> 0 };

# The error of q counts q / q_hat times as much.
(q_hat - q) * w * (q / q_hat) ->
  ((w * w - s * s) * (q / q_hat / (1 + s / w)) + (dh * w + ew * (w * w)) * (q / q_hat)) * (1 + eq)
  + q * eq * w * (q / q_hat) { w <> 0, 1 + s / w <> 0, q_hat <> 0 };
(second_hat - second) * w ->
  dc * (w / q_hat) * (1 + e2) - (second / q) * ((q_hat - q) * w * (q / q_hat)) * (1 + e2)
  + second / q * q * w * e2 { q <> 0, q_hat <> 0 };

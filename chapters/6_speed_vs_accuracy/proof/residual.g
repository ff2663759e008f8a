# Bound R, the residual: see book/notes/proofs.md. Lengths are counted in L, so that M is
# from 1 to 4. Of each coordinate, h is the part on the grid. What is below it are x + y
# of the point and v + e of the center; the radius, which rides along, has no point.

@rnd = float<ieee_64, ne>;

hx = fixed<-25, ne>(hx_); hy = fixed<-25, ne>(hy_);
hz = fixed<-25, ne>(hz_); hr = fixed<-25, ne>(hr_);

# The squares on the grid.
grid rnd= (hx * hx + hz * hz) + (hy * hy - hr * hr);
Grid = (hx * hx + hz * hz) + (hy * hy - hr * hr);

# What is left of F: all that has a part below the grid as a factor.
Lx = (xx + yx) - (vx + ex); lx rnd= (xx + yx) - (vx + ex);
Ly = (xy + yy) - (vy + ey); ly rnd= (xy + yy) - (vy + ey);
Lz = (xz + yz) - (vz + ez); lz rnd= (xz + yz) - (vz + ez);
bx rnd= (hx + hx + lx) * lx; Bx = (hx + hx + Lx) * Lx;
by rnd= (hy + hy + ly) * ly; By = (hy + hy + Ly) * Ly;
bz rnd= (hz + hz + lz) * lz; Bz = (hz + hz + Lz) * Lz;
br rnd= (hr + hr + lr) * lr; Br = (hr + hr + lr) * lr;
rest rnd= (bx + bz) + (by - br);
Rest = (Bx + Bz) + (By - Br);

{ |hx| <= 1025b-9 /\ |hy| <= 1025b-9 /\ |hz| <= 1025b-9 /\ |hr| <= 1025b-9   # r < 2
/\ hx * hx + hz * hz in [0, 1025b-8]
/\ Grid in [-1, 1]          # F is nearly 0
/\ |xx| <= 1b-26 /\ |yx| <= 93b-30 /\ |vx| <= 1b-26 /\ |ex| <= 1b-52
/\ |xy| <= 1b-26 /\ |yy| <= 93b-30 /\ |vy| <= 1b-26 /\ |ey| <= 1b-52
/\ |xz| <= 1b-26 /\ |yz| <= 93b-30 /\ |vz| <= 1b-26 /\ |ez| <= 1b-52
/\ |lr| <= 1b-26
->
   grid - Grid in [0, 0]
/\ rest - Rest in [-13b-74, 13b-74] }   # less than 2^-17 u

bx - Bx -> (bx - (hx + hx + lx) * lx) + (lx - Lx) * (hx + hx + lx + Lx);
by - By -> (by - (hy + hy + ly) * ly) + (ly - Ly) * (hy + hy + ly + Ly);
bz - Bz -> (bz - (hz + hz + lz) * lz) + (lz - Lz) * (hz + hz + lz + Lz);

"""Reference courses of x'' + u sqrt(x) x' + x^(3/2) = 0 for course.csv, with mpmath: extrapolation (Gragg, Bulirsch, Stoer),
in the phase plane at both ends and time around the turning point."""
from mpmath import mp, mpf, sqrt
mp.dps = 30
def gbs(f, y, x0, x1, steps, cols=14):
    H = (x1 - x0)/steps
    for k in range(steps):
        x = x0 + k*H; T = []
        for j in range(1, cols+1):
            n = 2*j; h = H/n
            a = y; b = [p + h*q for p, q in zip(y, f(x, y))]
            for i in range(1, n):
                c = [p + 2*h*q for p, q in zip(a, f(x+i*h, b))]; a, b = b, c
            e = f(x+H, b)
            s = [(p + q + h*r)/2 for p, q, r in zip(a, b, e)]
            row = [s]
            for m in range(1, j):
                r = mpf(2*j)/(2*(j-m))
                row.append([p + (p-q)/(r*r-1) for p, q in zip(row[-1], T[-1][m-1])])
            T.append(row)
        y = T[-1][-1]
    return y
def course(u):
    plane = lambda z, y: [-2*z*(u*z + z**3/y[0]), 2*z/y[0]]           # p(z), t(z)
    motion = lambda t, y: [y[1], -sqrt(y[0])*(u*y[1] + y[0])]          # x(t), v(t)
    z1 = mpf('0.4')/(1+u/4)
    p, t = gbs(plane, [mpf(1), mpf(0)], mpf(0), z1, 12)
    x, v = z1*z1, p
    # by time to the turning point: Newton on v(t) = 0
    h = mpf(0)
    total = t
    for _ in range(60):
        step = -v/motion(0, [x, v])[1]
        if abs(step) < mpf(10)**-24: break
        step = min(step, mpf('0.25'))
        x, v = gbs(motion, [x, v], mpf(0), step, 4); total += step
    xm, tt = x, total
    # out by time to a small |v| phase, then by the phase plane
    x, v = gbs(motion, [x, v], mpf(0), mpf('0.4'), 10); total += mpf('0.4')
    z = sqrt(x)
    # zero force: solve z^2 + u p = 0 along z by Newton
    zf, pf, tf = z, v, total
    for _ in range(80):
        g = zf*zf + u*pf
        d = 2*zf + u*plane(zf, [pf, 0])[0]
        dz = -g/d
        if abs(dz) < mpf(10)**-24: break
        lim = zf/8
        dz = max(min(dz, lim), -lim)
        pf, tf = gbs(plane, [pf, tf], zf, zf+dz, 4); zf += dz
    pe, te = gbs(plane, [pf, tf], zf, mpf(0), 60)
    return xm, tt, te, tf, -pe, -pf
for u in ['0.01','0.05','0.1','0.2','0.35','0.5','0.75','1','1.25','1.5','2','2.5','3']:
    r = course(mpf(u)); print(','.join([u]+[mp.nstr(q,20) for q in r[:4]]))

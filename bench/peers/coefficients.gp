\\ Expansion coefficients with PARI/GP: C_1 .. C_K to about D digits, as coefficients.py; without error bounds.
\\ usage: K=40 D=100 gp -q -f -s 4G coefficients.gp

\\ The variable s stands for (t/T)^(5/2), so that no coefficient is too small for its absolute precision;
\\ sqrt(1) is a real 1 at the precision of the moment, where 1. would have that of the start.
weighted(f, n, w) = Ser(vector(n, j, polcoef(f, j - 1) * w(j - 1)), s, n);
cut(f, n) = Ser(vector(n, j, polcoef(f, j - 1)), s, n);

undamped(len, ts) = {
  my(f = sqrt(1) + O(s), n = 1, known, r, v, a, w);
  while(n < len,
    known = n; n = min(2 * n, len);
    f = Ser(vector(n, j, if(j <= known, polcoef(f, j - 1), 0)), s, n);
    r = weighted(f, n, j -> 5*j/2 * (5*j/2 + 1)) + cut(f * sqrt(f) * s * ts, n);
    v = weighted(f, n, j -> 5*j/2 + 1);
    a = v * r;
    a = Ser(vector(n, j, if(j == 1, 0, polcoef(a, j - 1) / (5*(j - 1)/2))), s, n);
    w = 1 / v;
    f = f - weighted(cut(a * w * w, n), n, j -> 1 / (5*j/2 + 1)) * v);
  f
}

trajectories(order, len, ts) = {
  my(f0 = undamped(len, ts), root = sqrt(f0), v = weighted(f0, len, j -> 5*j/2 + 1), w = 1 / v, w2 = w * w);
  my(inverse = 1 / f0, f = List([f0]), h = List([f0 * root]), lower, right, a);
  for(n = 1, order,
    lower = sum(k = 1, n - 1, (3*k/2 - (n - k)) * f[k + 1] * h[n - k + 1], O(s^len));
    lower = cut(lower * inverse / n, len);
    right = weighted(h[n], len, j -> (5*j + 3*n)/3) + cut(lower * s * ts, len);
    a = weighted(cut(v * right, len), len, j -> 2 / (5*j + 3*n));
    listput(f, -(weighted(cut(a * w2, len), len, j -> 2 / (5*j + 3*n + 2)) * v));
    if(n < order, listput(h, 3/2 * root * f[n + 1] + lower)));
  Vec(f)
}

\\ The largest compression as a series in u, from x_n(T) and x_n'(T).
compression(order, position, velocity) = {
  my(degree = order + 2, e = O(u^(order + 1)), x, root, half, y, shift, value, slope, right);
  x = List([Ser(position, u, order + 1), Ser(velocity, u, order + 1)]);
  root = List([sqrt(x[1])]); half = 1 / (2 * root[1]);
  for(k = 0, degree - 2,
    if(k >= 1, listput(root, (x[k + 1] - sum(i = 1, k - 1, root[i + 1] * root[k - i + 1], e)) * half));
    listput(x, -sum(i = 0, k, root[i + 1] * (u * x[k - i + 2] * (k - i + 1) + x[k - i + 1]), e) / ((k + 1) * (k + 2))));
  shift = e; right = 1;
  while(right < order + 1,
    right *= 2; value = e; slope = e;
    forstep(m = degree, 1, -1, value = value * shift + x[m + 1] * m);
    forstep(m = degree, 2, -1, slope = slope * shift + x[m + 1] * m * (m - 1));
    shift -= value / slope);
  y = e;
  forstep(m = degree, 0, -1, y = y * shift + x[m + 1]);
  y
}

\\ epsilon = h^5 with h^4 Y(-u h) = Y(u).
inverse_collision(order, y) = {
  my(h = sqrt(1) + O(u), full, power, step, total);
  for(k = 1, order,
    full = Ser(vector(k + 1, j, if(j <= k, polcoef(h, j - 1), 0)), u, k + 1);
    power = full^4; step = -u * full; total = O(u^(k + 1));
    for(n = 0, k, total += power * polcoef(y, n); power *= step);
    h = full + (polcoef(y, k) - polcoef(total, k)) / (4 * polcoef(y, 0)) * u^k);
  h^5
}

coefficients(order, digits) = {
  my(guard = floor(0.6 * order) + 10, len, f, T, ts, tw, x, v);
  localprec(digits + guard + 10);
  len = floor((digits + guard) / 0.74) + floor(0.5 * order) + 11;
  T = (4/5)^(3/5) * gamma(2/5) * sqrt(Pi) / (2 * gamma(9/10)); ts = T^(5/2); tw = T^(3/2);
  f = trajectories(order, len, ts);
  x = vector(order + 1, n, vecsum(Vec(f[n])) * tw^(n - 1) * T);
  v = vector(order + 1, n, vecsum(Vec(weighted(f[n], len, j -> (5*j + 3*(n - 1))/2 + 1))) * tw^(n - 1));
  inverse_collision(order, compression(order, x, v))
}

{
  my(K = eval(getenv("K")), D = eval(getenv("D")), start, c);
  start = getwalltime();
  c = coefficients(K, D);
  print((getwalltime() - start) / 1000.);
  default(realprecision, D + 5);
  for(k = 1, K, print(k, ",", polcoef(c, k)));
  quit
}

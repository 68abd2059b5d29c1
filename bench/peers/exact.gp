\\ Exact trajectories with PARI/GP: the first J+1 coefficients of x_0 .. x_N, as exact.py.
\\ usage: N=3 J=200 gp -q -f -s 4G exact.gp

weighted(f, w) = my(n = serprec(f, s)); Ser(vector(n, j, polcoef(f, j - 1) * w(j - 1)), s, n);
cut(f, n) = Ser(vector(n, j, polcoef(f, j - 1)), s, n);

undamped(len) = {
  my(f = 1 + O(s), n = 1, known, r, v, a, w);
  while(n < len,
    known = n; n = min(2 * n, len);
    f = Ser(vector(n, j, if(j <= known, polcoef(f, j - 1), 0)), s, n);
    r = weighted(f, j -> 5*j/2 * (5*j/2 + 1)) + cut(f * sqrt(f) * s, n);
    v = weighted(f, j -> 5*j/2 + 1);
    a = v * r;
    a = Ser(vector(n, j, if(j == 1, 0, polcoef(a, j - 1) / (5*(j - 1)/2))), s, n);
    w = 1 / v;
    f = f - weighted(cut(a * w * w, n), j -> 1 / (5*j/2 + 1)) * v);
  f
}

trajectories(order, len) = {
  my(f0 = undamped(len), root = sqrt(f0), v = weighted(f0, j -> 5*j/2 + 1), w = 1 / v, w2 = w * w, inverse = 1 / f0);
  my(f = List([f0]), h = List([f0 * root]), lower, right, a);
  for(n = 1, order,
    lower = sum(k = 1, n - 1, (3*k/2 - (n - k)) * f[k + 1] * h[n - k + 1], O(s^len));
    lower = cut(lower * inverse / n, len);
    right = weighted(h[n], j -> (5*j + 3*n)/3) + cut(lower * s, len);
    a = weighted(cut(v * right, len), j -> 2 / (5*j + 3*n));
    listput(f, -(weighted(cut(a * w2, len), j -> 2 / (5*j + 3*n + 2)) * v));
    if(n < order, listput(h, 3/2 * root * f[n + 1] + lower)));
  Vec(f)
}

{
  my(N = eval(getenv("N")), J = eval(getenv("J")), start, f);
  start = getwalltime();
  f = trajectories(N, J + 1);
  print((getwalltime() - start) / 1000.);
  for(n = 0, N, for(j = 0, J, my(q = polcoef(f[n + 1], j)); print(n, ",", j, ",", numerator(q), "/", denominator(q))));
  quit
}



def M(*p):
    """Iterated Beta integral over -1 < v_r < ... < v_1 < 1 of prod (1-v_i^2)^(p_i-1) v_i^2 dv_i."""
    half, length = mpf(1)/2, len(p)

    def series(p, outer):
        """Integrals of p[i:] for every i: from v = -1 to -sqrt(1/2), or from 0 to sqrt(1/2)."""
        values, count = [mpf(1)], mp.prec + 60 + (0 if outer else int(16*sum(p)))
        w = [mpf(1)] + [mpf(0)]*count
        for i in reversed(range(len(p))):
            sigma, r, u = sum(p[i:]), len(p) - i, []
            for n in range(count):
                last = u[-1] if u else mpf(0)
                if outer:
                    step = (w[n] - w[n-1])/2 if n else w[n]/2
                    u.append(((r % 2)*(sigma + n - half)*last + step)/(sigma + n))
                else:
                    u.append(((3*r + 2*n - 2 + 2*sigma)*last + w[n])/(3*r + 2*n))
            total = sum(ldexp(c, -n) for n, c in enumerate(u))
            values.append(total*half**(sigma + half*((r % 2) if outer else 3*r)))
            w = u + [mpf(0)]
        return values[::-1]

    def table(outer, back):
        rows = {}
        for end in range(length + 1):
            part = p[length-end:][::-1] if back else p[:end]
            for start, value in enumerate(series(part, outer)):
                rows[(length - end, length - start) if back else (start, end)] = value
        return rows

    def join(later, earlier):
        return {(i, k): sum(later[i, j]*earlier[j, k] for j in range(i, k + 1)) for i, k in earlier}

    before = join(table(False, True), table(True, False))
    after = join(table(True, True), table(False, False))
    return join(after, before)[0, length]

/* A pressure relief valve with impacts over its flow rate, as one would write it for this problem
   alone: Tsitouras' method of order 5 with its interpolant, impacts by bisection.

   Ch. Tsitouras, Runge-Kutta pairs of order 5(4) satisfying only the first column simplifying
   assumption, Computers and Mathematics with Applications 62 (2011), pp. 770-775. */
#include <math.h>

#define N 3
enum { STAGES = 7 };
static const double
    A10 = 0.161,
    A20 = -0.008480655492356989, A21 = 0.335480655492357,
    A30 = 2.8971530571054935, A31 = -6.359448489975075, A32 = 4.3622954328695815,
    A40 = 5.325864828439257, A41 = -11.748883564062828, A42 = 7.4955393428898365,
    A43 = -0.09249506636175525,
    A50 = 5.86145544294642, A51 = -12.92096931784711, A52 = 8.159367898576159,
    A53 = -0.071584973281401, A54 = -0.028269050394068383,
    B0 = 0.09646076681806523, B1 = 0.01, B2 = 0.4798896504144996, B3 = 1.379008574103742,
    B4 = -3.290069515436081, B5 = 2.324710524099774,
    E0 = 0.001780011052226, E1 = 0.000816434459657, E2 = -0.007880878010262,
    E3 = 0.144711007173263, E4 = -0.582357165452555, E5 = 0.458082105929187, E6 = -1.0 / 66.0;

static inline void rates(double flow, const double *x, double *out) {
    out[0] = x[2];
    out[1] = 20.0 * (flow - x[0] * sqrt(x[1]));
    out[2] = x[1] - x[0] - 10.0 - 1.25 * x[2];
}

static inline void between(const double *x, double h, double s, double k[STAGES][N], double *out) {
    const double s2 = s * s;
    const double b[STAGES] = {
        -1.0530884977290216 * s * (s - 1.3299890189751412)
            * (s2 - 1.4364028541716351 * s + 0.7139816917074209),
        0.1017 * s2 * (s2 - 2.1966568338249754 * s + 1.2949852507374631),
        2.490627285651252793 * s2 * (s2 - 2.38535645472061657 * s + 1.57803468208092486),
        -16.54810288924490272 * (s - 1.21712927295533244) * (s - 0.61620406037800089) * s2,
        47.37952196281928122 * (s - 1.203071208372362603) * (s - 0.658047292653547382) * s2,
        -34.87065786149660974 * (s - 1.2) * (s - 0.666666666666666667) * s2,
        2.5 * (s - 1.0) * (s - 0.6) * s2};
    for (int i = 0; i < N; i++) {
        double sum = 0.0;
        for (int j = 0; j < STAGES; j++) sum += b[j] * k[j][i];
        out[i] = x[i] + h * sum;
    }
}

/* Integrate from rest to `end`; x is the state there. Return the number of impacts. */
static long motion(double flow, double end, double tolerance, double *x) {
    double t = 0.0, h = 1e-3, last = 1e-4, k[STAGES][N], y[N];
    long impacts = 0;
    x[0] = 0.2, x[1] = 0.0, x[2] = 0.0;
    rates(flow, x, k[0]);
    while (t < end) {
        if (t + h > end) h = end - t;
#define STAGE(number, sum) \
    for (int i = 0; i < N; i++) y[i] = x[i] + h * (sum); \
    rates(flow, y, k[number])
        STAGE(1, A10 * k[0][i]);
        STAGE(2, A20 * k[0][i] + A21 * k[1][i]);
        STAGE(3, A30 * k[0][i] + A31 * k[1][i] + A32 * k[2][i]);
        STAGE(4, A40 * k[0][i] + A41 * k[1][i] + A42 * k[2][i] + A43 * k[3][i]);
        STAGE(5, A50 * k[0][i] + A51 * k[1][i] + A52 * k[2][i] + A53 * k[3][i] + A54 * k[4][i]);
        STAGE(6, B0 * k[0][i] + B1 * k[1][i] + B2 * k[2][i] + B3 * k[3][i] + B4 * k[4][i]
                     + B5 * k[5][i]);
        double squares = 0.0;
        for (int i = 0; i < N; i++) {
            const double sum = E0 * k[0][i] + E1 * k[1][i] + E2 * k[2][i] + E3 * k[3][i]
                               + E4 * k[4][i] + E5 * k[5][i] + E6 * k[6][i];
            const double part = h * sum / (tolerance * (1.0 + fmax(fabs(x[i]), fabs(y[i]))));
            squares += part * part;
        }
        const double error = sqrt(squares / N);
        if (!(error < 1.0)) {
            h *= error == error ? fmax(0.2, 0.9 * pow(error, -0.2)) : 0.25;
            continue;
        }
        if (x[0] >= 0.0 && y[0] < 0.0) {
            double low = 0.0, high = 1.0;
            while (high - low > 1e-15) {
                const double middle = 0.5 * (low + high);
                between(x, h, middle, k, y);
                if (y[0] > 0.0) low = middle;
                else high = middle;
            }
            between(x, h, high, k, y);
            t += high * h, h *= 0.1, last = 1e-4, impacts++;
            x[0] = 0.0, x[1] = y[1], x[2] = -0.8 * y[2];
            rates(flow, x, k[0]);
            continue;
        }
        t += h;
        const double small = fmax(error, 1e-10);
        h *= fmin(6.0, fmax(0.2, 0.9 * pow(small, -0.14) * pow(last, 0.08)));
        last = fmax(error, 1e-4);
        for (int i = 0; i < N; i++) x[i] = y[i], k[0][i] = k[6][i];
    }
    return impacts;
}

long valves(int count, const double *flows, double end, double tolerance, double *states) {
    long impacts = 0;
    for (int j = 0; j < count; j++) impacts += motion(flows[j], end, tolerance, states + N * j);
    return impacts;
}

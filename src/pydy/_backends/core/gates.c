/* Functions of Python's own C interface: a tenth of what ctypes costs a call.

   They read NumPy's array object at the offsets of `pydy._array_layout`; where those do not hold,
   ctypes does it after all. A function's `self`, or its first argument, is an array whose numbers
   say what is called. */

#include "kernel.h"
#include "layout.h"

typedef char Object;
extern Object PyFloat_Type, _Py_TrueStruct;
Object *PyLong_FromLongLong(long long);
void *PyEval_SaveThread(void);
void PyEval_RestoreThread(void *);
Object *PyErr_Occurred(void);
Object *PyObject_CallNoArgs(Object *);
void Py_DecRef(Object *);

#define FIELD(object, offset, type) (*(type *)((object) + (offset)))
#define NUMBERS(array) FIELD(array, DATA, double *)

/* One state at a time, of rows. */
int64_t sweep_1(
    const Words *w, const double *t, const double *x, const double *r, const double *p,
    double *out, uint8_t *failed, double *scratch)
{
    int64_t bits = 0;
    w->prepare(p, scratch);
    for (int64_t i = 0; i < w->m; i++) {
        double *results = out + i * w->out.sample;
        failed[i] = (uint8_t)w->kernel(
            t + i, x + i * w->x.sample, r + i * w->r.sample, scratch, results);
        /* v - v has bits only if v is not finite. */
        for (int64_t j = 0; j < w->outputs; j++) {
            const union { double value; int64_t bits; } rest = {results[j] - results[j]};
            bits |= rest.bits;
        }
    }
    return bits == 0;
}

static Distances distances(const Object *array)
{
    const int64_t *bytes = FIELD(array, STRIDES, const int64_t *);
    return (Distances){bytes[0] / 8, bytes[1] / 8};
}

/* sweep(words, t, x, r, p, out, failed, scratch): arrays of the right kinds, which the caller has
   made. Gives whether all results are known to be finite. */
Object *sweep_gate(Object *self, Object *const *args, int64_t count)
{
    (void)self, (void)count;
    Words w = *FIELD(args[0], DATA, const Words *);
    w.m = *FIELD(args[1], SHAPE, const int64_t *);
    w.x = distances(args[2]), w.r = distances(args[3]), w.out = distances(args[5]);
    if (*FIELD(args[3], SHAPE, const int64_t *) == 1) w.r.sample = 0;
    void *thread = PyEval_SaveThread();
    const int64_t finite = w.sweep(
        &w, NUMBERS(args[1]), NUMBERS(args[2]), NUMBERS(args[3]), NUMBERS(args[4]),
        NUMBERS(args[5]), FIELD(args[6], DATA, uint8_t *), NUMBERS(args[7]));
    PyEval_RestoreThread(thread);
    return PyLong_FromLongLong(finite);
}

/* What a kernel is, and the binding of its constants: `bound` is the `prepare` that gave c of p,
   which follow, or 0. */
typedef struct {
    Kernel *kernel;
    Prepare *prepare;
    int64_t n, s, k, carried, outputs;
    Prepare *bound;
    double numbers[];
} Bound;

/* Whether an array has so many numbers, one after the other, of the same kind as a pattern. */
static int fits(const Object *array, const Object *pattern, int64_t size)
{
    return FIELD(array, KIND, const void *) == FIELD(pattern, KIND, const void *) &&
           FIELD(array, DESCR, const void *) == FIELD(pattern, DESCR, const void *) &&
           FIELD(array, NDIM, int32_t) == 1 && (FIELD(array, FLAGS, int32_t) & 0x0101) == 0x0101 &&
           *FIELD(array, SHAPE, const int64_t *) == size;
}

/* call(x, t, r, p, out) gives the status, or -1 for arguments of other kinds; `out` is ours. */
Object *kernel_gate(Object *self, Object *const *args, int64_t count)
{
    Bound *b = FIELD(self, DATA, Bound *);
    if (count != 5 || !b->kernel || !fits(args[0], args[4], b->n) ||
        FIELD(args[1], KIND, const Object *) != &PyFloat_Type || !fits(args[2], args[4], b->s) ||
        !fits(args[3], args[4], b->k))
        return PyLong_FromLongLong(-1);
    const double t = FIELD(args[1], FLOAT, double), *given = NUMBERS(args[3]);
    double *p = b->numbers, *c = p + b->k;
    const uint64_t size = 8 * (uint64_t)b->k;
    if (__builtin_memcmp(p, given, size) || b->bound != b->prepare) {
        __builtin_memcpy(p, given, size);
        b->prepare(p, c);
        b->bound = b->prepare;
    }
    return PyLong_FromLongLong(
        b->kernel(&t, NUMBERS(args[0]), NUMBERS(args[2]), c, NUMBERS(args[4])));
}

/* step(states, fresh) of a solver's loop and its table, without the interpreter's lock. */
Object *step_gate(Object *self, Object *const *args, int64_t count)
{
    (void)count;
    const int64_t *words = FIELD(self, DATA, const int64_t *);
    int64_t (*entry)(int64_t, double *, int64_t) = (int64_t (*)(int64_t, double *, int64_t))words[0];
    void *thread = PyEval_SaveThread();
    const int64_t code = entry(words[1], NUMBERS(args[0]), args[1] == &_Py_TrueStruct);
    PyEval_RestoreThread(thread);
    return PyLong_FromLongLong(code);
}

/* The kernel that calls a Python object. Its constants are that, a buffer, and how many numbers of
   it are states and results. It is called with the interpreter's lock held; with an exception set,
   Python must not be entered again. */
int32_t call_python(
    const double *t, const double *x, const double *r, const double *c, double *out)
{
    (void)r;
    const struct { Object *object; double *buffer; int64_t states, results; } *own = (const void *)c;
    if (PyErr_Occurred()) return -1;
    own->buffer[0] = *t;
    __builtin_memcpy(own->buffer + 1, x, 8 * (uint64_t)own->states);
    Object *answer = PyObject_CallNoArgs(own->object);
    if (!answer) return -1;
    Py_DecRef(answer);
    __builtin_memcpy(out, own->buffer + 1 + own->states, 8 * (uint64_t)own->results);
    return 0;
}

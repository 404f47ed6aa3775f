"""Thresholds of compiled code, each with what it was found by.

Times are of eight lanes on a processor with AVX-512 (docs/decisions/02-register-allocation.md),
unless it says otherwise. What depends on the processor is in `pydy._backends.llvm.targets`.
"""

# Registers left to intermediate results. Fewer: LLVM moves values to memory a second time; more:
# no gain.
TEMPORARY = 5

# Angles of one state whose sines and cosines are computed side by side, at most. Eight are a
# register of AVX-512. While such an instruction is on its way, Intel's processors have one port for
# scalar arithmetic in place of two (Intel 64 and IA-32 Architectures Optimization Reference Manual,
# of port 1 with AVX-512): scalar code took 1.2 to 2.1 times as long.
PACKED = 4

# Operations from which code does not fit the processor's cache for it, and those for one result of
# models that do little but the same for each: 300 masses in half the time where LLVM looks for
# them, in 3 to 5 times the compile time. With AVX2, 100 masses in 0.83 of the time where all eight
# lanes go at once instead of four and four (EPYC, Zen 3).
LARGE = 1500
SHORT = 6

# The share of operations that are needed without fallbacks up to which those are compiled only when
# they are needed: compiled later they take longer.
MOST_WITHOUT_FALLBACKS = 0.75

# Entries of a matrix for each one that is computed at every call, from which only those are kept
# for a fallback: 100 springs have 10,000 entries and compute none.
SPARSE = 4

# States from which code for several at once is compiled: it would have saved as much time by then:
# 0.37 to 0.76 million for 5, 10 and 20 links, three rods and two bicycles (AVX-512).
COMPILED_FROM = 500_000

# States from which it is read from the cache on disk, which takes some milliseconds.
READ_FROM = 10_000

# Operations of a sweep between two looks at whether there is a Ctrl-C: some hundredths of a second.
SWEPT = 10_000_000

# Samples whose columns are copied together: whole lines of the cache, of which processors fetch
# the next ones by themselves.
TILE = 32

# Numbers of states, specifieds and results, 250 KiB, that stay in a core's own cache: they are read
# and written in place, or copied as one tile.
NEARBY = 32_000

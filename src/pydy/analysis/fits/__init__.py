"""Fits of parameters to measured motions.

A fit goes through the modules in this order: `trial` (a measured motion as a user gives it),
`samples` (as it was checked), `problem` (the unknown numbers, and the motions that they make),
`shooting` or `collocation` (which minimise the residuals; `search` is the least squares of
shooting), `residuals` (are they white noise?) and `result`. `fit` calls them.
"""

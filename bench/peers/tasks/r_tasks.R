# The tasks of bench/peers/run with R, as its users write them; task_program.hpp says the protocol.

exponents_of <- list(T2 = 3:15, "T2-large" = c(100, 1e3, 1e4, 1e6), T3 = 2^(1:11))
published <- as.numeric(Sys.getenv(c("PUBLISHED_A", "PUBLISHED_B"), names = FALSE))
if (anyNA(published)) stop("PUBLISHED_A and PUBLISHED_B are not set")

pair <- function(c, a, b) 2^((a * c + b) * c)
schlick <- function(c) (1 - c)^5

value <- function(name, number, exponent = NA)
  list(values = list(list(name, exponent, number)), notes = character())
note <- function(text) list(values = list(), notes = text)
together <- function(answers)
  list(values = do.call(c, lapply(answers, `[[`, "values")), notes = unique(unlist(lapply(answers, `[[`, "notes"))))
pair_answer <- function(p) together(list(value("a", p[[1]]), value("b", p[[2]])))

# ---- T1 ----------------------------------------------------------------------------------------------------

pair_nls <- function() {
  c <- seq(0, 1, length.out = 1001)
  y <- schlick(c)
  pair_answer(coef(nls(y ~ 2^((a * c + b) * c), start = list(a = -5, b = -5))))
}
pair_integral <- function(p) integrate(function(c) (pair(c, p[1], p[2]) - schlick(c))^2, 0, 1)$value
pair_optim <- function(method) {
  found <- optim(c(-5, -5), pair_integral, method = method)
  together(list(pair_answer(found$par), note(paste0("convergence ", found$convergence))))
}
pair_nlm <- function() {
  c <- seq(0, 1, length.out = 1001)
  y <- schlick(c)
  pair_answer(nlm(function(p) sum((pair(c, p[1], p[2]) - y)^2), c(-5, -5))$estimate)
}

# ---- T2 and T3 -----------------------------------------------------------------------------------------------

# Each exponent by itself: a fit that fails says so and the others go on.
sweep <- function(task, fit) together(lapply(exponents_of[[task]], function(k)
  tryCatch(value("x", fit(k), k), error = function(e) note(sprintf("%s at %g", conditionMessage(e), k)))))

lobe_nls <- function(k) {
  c <- seq(0, 1, length.out = 1001)
  y <- c^k
  coef(nls(y ~ exp((k + x) * (c - 1)), start = list(x = 0.5)))[[1]]
}
lobe_optimize <- function(k)
  optimize(function(x) integrate(function(c) (exp((k + x) * (c - 1)) - c^k)^2, 0, 1)$value, c(0, 2))$minimum
lobe_uniroot <- function(k) {
  gradient <- function(x) integrate(function(t) {
    form <- exp(-(k + x) * t / k)
    (form - exp(k * log1p(-t / k))) * form * t
  }, 0, min(k, 24), rel.tol = 1e-13, abs.tol = 1e-17, stop.on.error = FALSE)$value
  uniroot(gradient, c(0, 2), tol = 4e-16)$root
}
blinn_nls <- function(rho) {
  theta <- seq(0, pi / 2, length.out = 1001)
  y <- pmax(cos(theta), 0)^rho
  coef(nls(y ~ cos(theta / 2)^(x * rho), start = list(x = 3), weights = sin(theta)))[[1]]
}
blinn_optimize <- function(rho)
  optimize(function(x) integrate(function(t) (cos(t / 2)^(x * rho) - cos(t)^rho)^2 * sin(t), 0, pi / 2)$value,
           c(3, 6))$minimum
blinn_uniroot <- function(rho) {
  gradient <- function(x) integrate(function(t) {
    half <- log1p(-t / (2 * rho))
    form <- exp(x * rho / 2 * half)
    (form - exp(rho * log1p(-t / rho))) * form * half
  }, 0, min(rho, 24), rel.tol = 1e-13, abs.tol = 1e-17, stop.on.error = FALSE)$value
  uniroot(gradient, c(3, 6), tol = 4e-16)$root
}

# ---- T4, T5, T6 ----------------------------------------------------------------------------------------------

minimax <- function(is_relative) {
  c <- seq(0, 1, length.out = 1001)
  y <- schlick(c)
  w <- if (is_relative) 0.96 / (0.04 + 0.96 * y) else 1
  pair_answer(optim(published, function(p) max(abs(w * (pair(c, p[1], p[2]) - y))))$par)
}
error_at <- function(c) abs(pair(c, published[1], published[2]) - schlick(c))
largest_refined <- function() {
  c <- seq(0, 1, length.out = 1001)
  i <- which.max(error_at(c))
  value("level", optimize(error_at, c[c(i - 1, i + 1)], maximum = TRUE, tol = 1e-10)$objective)
}
constants <- function(in_angle) {
  lobes <- list(
    "norm-phong" = function(c, n) c^n,
    "norm-phong-brdf" = function(c, n) c^n * c,
    "norm-blinn-phong" = function(c, n) ((1 + c) / 2)^(n / 2),
    "norm-blinn-phong-brdf" = function(c, n) ((1 + c) / 2)^(n / 2) * c)
  together(unlist(lapply(c(0.1, 1, 2, 8, 64, 2048, 1e5, 1e6), function(n) lapply(names(lobes), function(name) {
    lobe <- lobes[[name]]
    integral <- tryCatch(
      if (in_angle) integrate(function(t) lobe(cos(t), n) * sin(t), 0, pi / 2, rel.tol = 1e-12, abs.tol = 0)$value
      else integrate(lobe, 0, 1, n, rel.tol = 1e-12, abs.tol = 0)$value,
      error = function(e) e)
    if (inherits(integral, "error")) note(sprintf("%s at %g", conditionMessage(integral), n))
    else value(name, 1 / (2 * pi * integral), n)
  })), recursive = FALSE))
}

variants <- list(
  list("T1", "nls, 1001 samples", pair_nls),
  list("T1", "optim(integrate), Nelder-Mead", function() pair_optim("Nelder-Mead")),
  list("T1", "optim(integrate), BFGS", function() pair_optim("BFGS")),
  list("T1", "nlm, 1001 samples", pair_nlm),
  list("T2", "nls, 1001 samples", function() sweep("T2", lobe_nls)),
  list("T2", "optimize(integrate in c)", function() sweep("T2", lobe_optimize)),
  list("T2", "uniroot of the integrated gradient in t (expert)", function() sweep("T2", lobe_uniroot)),
  list("T2-large", "nls, 1001 samples", function() sweep("T2-large", lobe_nls)),
  list("T2-large", "optimize(integrate in c)", function() sweep("T2-large", lobe_optimize)),
  list("T2-large", "uniroot of the integrated gradient in t (expert)", function() sweep("T2-large", lobe_uniroot)),
  list("T3", "nls, 1001 samples", function() sweep("T3", blinn_nls)),
  list("T3", "optimize(integrate)", function() sweep("T3", blinn_optimize)),
  list("T3", "uniroot of the integrated gradient in t (expert)", function() sweep("T3", blinn_uniroot)),
  list("T4-absolute", "optim, Nelder-Mead on the largest of 1001 samples", function() minimax(FALSE)),
  list("T4-relative", "optim, Nelder-Mead on the largest of 1001 samples", function() minimax(TRUE)),
  list("T5", "grid of 1001, optimize", largest_refined),
  list("T6", "integrate in the angle", function() constants(TRUE)),
  list("T6", "integrate in the cosine", function() constants(FALSE)))

arguments <- commandArgs(trailingOnly = TRUE)
if (identical(arguments, "--list")) {
  cat(sprintf("version R %s.%s\n", R.version$major, R.version$minor))
  for (v in variants) cat(sprintf("%s\t%s\t%s\n", v[[1]], v[[2]], if (grepl("expert", v[[2]])) "expert" else "judged"))
} else {
  chosen <- Filter(function(v) identical(c(v[[1]], v[[2]]), arguments[1:2]), variants)
  if (length(arguments) != 3 || length(chosen) != 1) {
    message("usage: r_tasks.R --list, or TASK VARIANT SECONDS as it lists them")
    quit(status = 2)
  }
  run <- chosen[[1]][[3]]
  budget <- as.numeric(arguments[3])
  answer <- tryCatch(run(), error = function(e) note(conditionMessage(e)))
  for (v in answer$values)
    cat(sprintf("value %s %s %.17g\n", v[[1]], if (is.na(v[[2]])) "-" else sprintf("%.17g", v[[2]]), v[[3]]))
  for (text in answer$notes) cat(sprintf("note %s\n", gsub("\n", " ", text)))
  times <- c()
  while (budget > 0 && (length(times) < 3 || sum(times) < budget)) {
    start <- Sys.time()
    tryCatch(run(), error = function(e) NULL)
    times <- c(times, as.numeric(difftime(Sys.time(), start, units = "secs")))
  }
  if (length(times) > 0) cat(sprintf("seconds %.9g\n", min(times)))
}

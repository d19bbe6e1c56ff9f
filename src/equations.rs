//! The equations of the solver, each beside the function that holds it.
//!
//! # Discretisation
//!
//! A line of n segments has n + 1 nodes with positions x_i, velocities v_i and accelerations a_i
//! ([`State`](crate::solve::State)). Mass, submerged weight, drag and added mass of a segment are lumped to its two nodes by
//! halves ([`LumpedLine`](crate::scene::LumpedLine)); all errors are of second order in the segment length l0. With the chord
//! `d = x_{i+1} - x_i`, `l = |d|`, `t = d / l` ([`Chord`](crate::physics::tension::Chord)), the residual of the equation of
//! motion is
//!
//! ```text
//! R(t, x, v, a) = M(x) a - f(t, x, v) = 0
//! R_i = m_i a_i + w_i e_z                              mass and submerged weight of the node
//!     + sum over both halves [ M_a(t) (a_i - A_i) - F_D ]   added mass, drag
//!     -/+ T t                                           tension of the segments after and before
//!     + elements                                        bed, water, bending, bodies, traveller, payload
//! ```
//!
//! A_i is the acceleration of the water. The segments set R ([`Residual::residual`](crate::solve::Residual::residual)), the
//! [elements](crate::scene::elements) add to it. Prescribed nodes have no row
//! ([`Kinematics::prescribe`](crate::solve::Kinematics::prescribe)).
//!
//! | term | equation | function |
//! |---|---|---|
//! | tension | `T = EA e + C de/dt`, `e = l/l0 - 1`, `0 <= T <= 2 EA e`; a rod also bears compression | [`AxialConstants::tension`](crate::physics::tension::AxialConstants::tension) |
//! | pipe wall | `T_w = T + p_i A_i - p_o A_o` | [`PipeWall::tension`](crate::physics::PipeWall::tension) |
//! | drag, per length | `1/2 rho D (C_n abs(u_n) u_n + C_t abs(u_t) u_t)`, u relative to the water | [`DragProperties::drag`](crate::physics::drag::DragProperties::drag) |
//! | drag of an aligned clump | the same by areas, along `d = (t1 + t2) / abs(t1 + t2)` | [`NodeDirection`](crate::physics::NodeDirection) |
//! | added mass of an aligned clump | `(m_n (I - dd') + m_t dd') a`, along the same d | [`AddedMass`](crate::physics::added_mass::AddedMass) |
//! | added mass | `M_a a = A_n a + (A_t - A_n) (t.a) t` | [`AddedMass::force`](crate::physics::added_mass::AddedMass::force) |
//! | bending | energy `EI (1 - t1.t2) / l`, moment `EI sin(theta) / l` | [`BendAngle::forces`](crate::physics::bending::BendAngle::forces) |
//! | rotating body | Kirchhoff's equations and gyroscopic couple | [`RigidBody`](crate::physics::RigidBody) |
//! | waves | Froude-Krylov and added-mass force `(m_w + M_a) A`, drag by relative velocity | [`Water`](crate::scene::Water) |
//! | traveller | `A = sum n_k a_k + 2 s' n_k' v_k + (s'' n_k' + s'² n_k'') x_k` | [`TravellingBody`](crate::scene::TravellingBody) |
//!
//! # Bed contact and friction
//!
//! A node below the bed, by a depth p and with velocity v_n out of it, on the contact area `A = D l0`
//! ([`ElasticBed::push_at`](crate::physics::ElasticBed::push_at)):
//!
//! ```text
//! N = A (k p - c v_n),  0 <= N <= 2 A k p
//! ```
//!
//! Friction is elastic-plastic ([`Friction::grip`](crate::physics::bed_friction::Friction::grip)): a spring with a damper from the
//! anchor point g of the node pulls by `e = k_g (g - x) - c v` along the bed, up to an ellipse with the axes `mu_a N` along and
//! `mu_l N` transverse to the line:
//!
//! ```text
//! s = sqrt((e_a/mu_a)² + (e_l/mu_l)²)     F = e if s <= N, else e N/s
//! ```
//!
//! g moves only when a step is accepted ([`Hysteresis::commit`](crate::solve::Hysteresis::commit)): all iterates of a step have
//! the same history. The regularised law `F = -mu N v / max(|v|, v_lim)` is
//! [`Friction::regularised`](crate::physics::bed_friction::Friction::regularised).
//!
//! # Rope stiffness
//!
//! `T = k MBL e` or, about the mean state, `T = Tm + k MBL (e - e_m)`, with
//! `k = alpha + beta Lm - gamma La`: Lm is the running mean of the tension and La its deviation, in percent of the breaking load.
//! Both have a closed form in e ([`FibreRope::in_motion`](crate::physics::rope::FibreRope::in_motion)). The mean is a history
//! variable, advanced by the trapezoidal rule in [`Hysteresis::commit`](crate::solve::Hysteresis::commit) and extrapolated within
//! the step at its rate, so that second order is kept.
//!
//! Where the segments of a rope share one k, Lm and La are those of the tension averaged along it. The average strain, on which
//! k then depends, is extrapolated like the mean, so that the tangent stays that of each segment; at rest, k and the equilibrium are
//! solved for in turn ([`StaticSearch::share_stiffness`](crate::solve::StaticSearch::share_stiffness)).
//!
//! # Tangent
//!
//! Velocity and acceleration follow a displacement by the [`Factors`](crate::solve::Factors) c_v and c_a of the method; the
//! tangent `K = c_a dR/da + c_v dR/dv + dR/dx` is exact for all terms, also across slack and contact (semismooth Newton), and
//! tested against finite differences ([`Residual::linearise`](crate::solve::Residual::linearise)). Of a segment:
//!
//! ```text
//! dT t / dd = (dT/dl) t t' + (T/l) (I - t t') + damping        axial and geometric stiffness
//! ```
//!
//! It is block-tridiagonal in 3 x 3 blocks, block-pentadiagonal with bending, and factored by LDL^T from both ends
//! ([`BlockBand::solve`](crate::numerics::BlockBand::solve)). [`Newton::solve`](crate::solve::Newton::solve) iterates
//! `K d = R, x -= d, v -= c_v d, a -= c_a d` until the greatest displacement is below the tolerance, or, with the measured
//! quadratic rate `c = |d1| / |d0|²`, the next one is. Statics start with the mixed iteration: the T in the geometric stiffness
//! is extrapolated from the iterate before
//! ([`Residual::extrapolate_tensions`](crate::solve::Residual::extrapolate_tensions)).
//!
//! # Statics
//!
//! `R(x, 0, 0) = 0` from the closed-form catenary, by
//! [`EquilibriumSearch::run`](crate::statics::equilibrium::EquilibriumSearch::run). If Newton fails: pseudo-transient
//! continuation `M (x - x_k) / h² = f(x)`, with growing h; continuation in the angle of the clamps; dynamic relaxation with each
//! step converged. The number of negative pivots of K is that of unstable directions
//! ([`instabilities`](crate::statics::equilibrium::instabilities); Sylvester's law of inertia).
//!
//! # Generalized-alpha
//!
//! [`GeneralizedAlpha`](crate::dynamics::generalized_alpha::GeneralizedAlpha) (Chung and Hulbert 1993), with the spectral radius
//! rho at infinite frequency:
//!
//! ```text
//! alpha_m = (2 rho - 1)/(rho + 1)   alpha_f = rho/(rho + 1)
//! gamma = 1/2 - alpha_m + alpha_f   beta = (1 - alpha_m + alpha_f)²/4
//! x1 = x0 + h v0 + h² ((1/2 - beta) a0 + beta a1)      v1 = v0 + h ((1 - gamma) a0 + gamma a1)
//! R = 0  at  (1 - alpha_f) (t, x, v)_1 + alpha_f (t, x, v)_0,   (1 - alpha_m) a1 + alpha_m a0
//! c_v = gamma / (beta h)   c_a = (1 - alpha_m) / ((1 - alpha_f) beta h²)
//! ```
//!
//! Error of a step: in position `|beta - 1/6| h² |a1 - a0|` (Zienkiewicz and Xie 1991), in velocity by the second difference of
//! a. The [step control](crate::dynamics::step_control) halves and doubles h; output times change no step. Its numerical
//! damping and period elongation follow from the amplification matrix
//! ([`NumericalDamping::of_oscillator`](crate::dynamics::numerical_damping::NumericalDamping::of_oscillator)).
//!
//! # Quasi-static march
//!
//! `0 = f(t, x, v)`, v by BDF2 with variable step
//! ([`QuasiStatic`](crate::dynamics::quasi_static::QuasiStatic)): `c_a = 0`, and with r the ratio of the step to the one before
//! `c_v = (1 + 2 r) / (h (1 + r))`.
//!
//! # Runge-Kutta
//!
//! `a = M(x)^-1 f(t, x, v)` node by node, since lumped and added mass make 3 x 3 blocks
//! ([`ExplicitRhs::accelerate`](crate::solve::ExplicitRhs::accelerate)); bodies that couple nodes are corrected for afterwards.
//! [`Rk4`](crate::dynamics::rk4::Rk4) is stable for `omega h <= 2.785`
//! ([`Scene::explicit_limit`](crate::scene::Scene::explicit_limit)), with the highest frequency of a segment between masses m1, m2
//! and its damping ratio:
//!
//! ```text
//! omega² = (2 EA/l0 + 8 EI/l0³ + k_bed) (1/m1 + 1/m2)     zeta = C omega / (2 EA)
//! h = 2.785 / (omega max(1, zeta + sqrt(zeta² + 1)))
//! ```
//!
//! and for `lambda h <= 2.785`, lambda the rate at which drag and bed slow a node
//! ([`ExplicitRhs::fastest_decay`](crate::solve::ExplicitRhs::fastest_decay)).
//!
//! # The sea
//!
//! | | equation | function |
//! |---|---|---|
//! | dispersion | `omega² = g k tanh(k h)` | [`wave_number`](crate::physics::sea::wave_number) |
//! | spectra | Pierson-Moskowitz, JONSWAP | [`Spectrum`](crate::physics::sea::Spectrum) |
//! | record | components of equal energy, seeded | [`synthesise`](crate::physics::sea::synthesise) |
//!
//! # Closed-form catenary
//!
//! Single and composite lines in still water, on a sloping bed with friction ([`statics::catenary`](crate::statics::catenary)); H is the
//! horizontal tension, V_0 the vertical one at the upper end:
//!
//! ```text
//! x(s) = H s/EA + H/w (asinh(V_0/H) - asinh((V_0 - w s)/H))
//! z(s) = -s/EA (V_0 - w s/2) - (sqrt(V_0² + H²) - sqrt((V_0 - w s)² + H²))/w
//! ```
//!
//! # Modes
//!
//! `K x = omega² M x` at rest, without drag, by shift-invert block Lanczos ([`lowest`](crate::modes::lowest)); none is missing by
//! the count of negative pivots of `K - mu M` ([`Pencil::count_below`](crate::modes::ModePencil::count_below)). WKB theory:
//! `EI k⁴ + T k² = m omega²`, `(2 EI k³ + T k) a² = const` ([`modes::wave_number`](crate::modes::wave_number)).
//!
//! # Energy balance
//!
//! `dE/dt = P_ends + P_waves - D` ([`Scene::energy`](crate::scene::Scene::energy),
//! [`Scene::power_of_ends`](crate::scene::Scene::power_of_ends), [`Scene::power_of_waves`](crate::scene::Scene::power_of_waves),
//! [`Scene::dissipation`](crate::scene::Scene::dissipation)), tested for every force. With the growth of the added mass,
//! `P_growth = v' (dM/dt) v / 2`, it is integrated over every step of a run ([`Scene::read_step`](crate::scene::Scene::read_step),
//! `run/energy_balance.rs`).
//!
//! # Errors
//!
//! With order p and ratio r between two steps or meshes, the finer result is wrong by about `|fine - coarse| / (r^p - 1)`
//! (Richardson), for time step and mesh apart (`run/error_estimate.rs`).

"""The nouns of questions (see `questions`): who moves, what is asked of it, and what is counted over the motion."""

from __future__ import annotations

NOUNS = r"""
Thing
  (centre of mass|center of mass|mass centre|centre of gravity) [of system] -> @system_cm
  Point -> {Point}
  End -> {End}
  Body -> {Body}
  Coord -> {Coord}
  It -> {It}

End
  (foot|base|lower end|bottom end|bottom) [of Body] -> @lower_end
  (upper end|top|top end|head) [of Body] -> @upper_end
  (tip|free end|far end|outer end) [of Body] -> @tip

Subj
  Body -> {Body}
  Coord -> {Coord}
  Point -> {Point} !1
  It -> {It}
  End -> {End} !1

Holder
  Body -> {Body}
  It -> {It}

CoordNoun
  Coord -> {Coord}
  (angle|position|height|place|distance):x -> @coordinate

Spring
  Element -> @spring

String
  Element -> @string

State
  Sign (State) -> {Sign} {State}
  Noun of Thing -> {Noun} of {Thing}
  its Noun -> @its
  Noun -> @lone_noun !2
  Turns of Holder:a relative to Holder:b -> angular velocity of {a} relative to {b}
  [its] (terminal|limiting|steady|final|ultimate|maximum attainable) (speed|velocity|Turns):n [of Thing] -> @terminal
  common (speed|velocity|Turns):n of Each [(after|When|JustAfter) BlowClause] -> {n} of {Each} <2>right after impact
  (speeds|velocities|accelerations|angular velocities|angular accelerations):n of Each -> @each
  (Noun|kinetic energy):n of Each -> {n} of {Each}
  Several [on both sides|on each side|on either side|on both sides of Body] -> {Several}
  fraction of [initial|original] [kinetic|mechanical] energy [that is|which is|is] (lost|dissipated) [(in|during|by|at|on)
      [each] (BlowNoun):b|(in slipping|while slipping|to friction):f] -> @fraction
  fraction of [its] [total] kinetic energy (is|that is|which is|that is in|in) (rotational|rotation) -> ratio of
      rotational kinetic energy to kinetic energy
  fraction of [its] [total] kinetic energy (is|that is|which is|that is in|in) (translational|translation) -> ratio of
      translational kinetic energy to kinetic energy
  (speed|velocity|acceleration):n [of Thing] (down|along):x (incline|slope|plane|ramp|hill) -> @along
  RelNoun of Thing (relative to|with respect to) (ground|floor|earth) -> {RelNoun} of {Thing}
  RelNoun of Thing:a (relative to|with respect to|as seen from|seen from) Thing:b -> @relative
  relative RelNoun of Thing:a (and|to) Thing:b -> @relative
  (speed|velocity|angular velocity|angular speed):n with which Event -> @with_which
  (Noun|Turns):n (acquired|attained|gained|had|given to) by Thing -> @acquired
  height at which Event -> @height_at
  (speed|velocity|Turns):n [of Thing] (eventually|finally|after long time|in long run|in steady state|long time after
      Stranger) -> @terminal
  (acceleration|velocity|speed|force|tension|friction|normal force):n [of Thing] (on|during) way back -> @on_way
  (frictional|friction|resisting|braking|retarding) (torque|couple|moment) [on Body] -> @resisting
  (speed|velocity) (with|at) which Thing (Moving|Go|Turn|moves|comes|flies|passes) [(on|through|along|in) (Ground|Body)]
      -> speed of {Thing}
  (speed|velocity) (at|with) which Subj (Hit) HitWhat -> @strikes
  angle of Holder -> @angle_of
  equilibrium (angle|distance|position|height|length|value|coordinate) [of Thing] -> @equilibrium
  (period|frequency):x of damped (oscillations|oscillation|vibrations|vibration|swings|motion) -> damped {x}
  distance of Thing from Point -> @distance_from
  (torque|couple|moment) (of|from|exerted by|supplied by) Element -> @couple
  (angular deceleration|deceleration|angular retardation|retardation):x [of Thing] -> @slowing
  Turns of Holder -> {Turns} of {Holder}
  Turns -> {Turns} !1
  Energy of (Holder|system):x -> {Energy} of {x}
  Energy -> {Energy}
  (linear momentum|momentum) of Holder -> linear momentum of {Holder}
  angular momentum of (Holder|system):x [About] -> angular momentum of {x} {About}
  [total] angular momentum [About] -> angular momentum of system {About}
  (moment of inertia|radius of gyration):n of (Holder|system):x [About] -> {n} of {x} {About}
  [total] (moment of inertia|radius of gyration):n [About] -> {n} of system {About}
  (rotational inertia|mass moment of inertia) [of (Holder|system):x] [About] -> @inertia
  instantaneous (centre|center) [of rotation|of velocity|of zero velocity] of Holder -> instantaneous centre of {Holder}
  instantaneous (centre|center) [of rotation|of velocity|of zero velocity] -> @lone_centre
  distance (from|between) Point:a (to|and) Point:b -> distance from {a} to {b}
  height of Thing [above Ground] -> height of {Thing}
  Held -> {Held}
  (horizontal|vertical):x [component of|part of] Held -> @component
  (horizontal|vertical):x [component of|part of] Noun of Thing -> {x} component of {Noun} of {Thing}
  (direction|angle) of Held -> direction of {Held}
  (Swinging|Swinging of Thing) [about [its|stable] Resting] -> @swings
  (frequencies|normal frequencies|natural frequencies|normal mode frequencies|vibration frequencies|frequencies of [two|
      three] normal modes|frequencies of vibration|natural frequencies of vibration) [of system] -> frequencies
  [angle|position|distance|value] [of Thing] (when|in|at|for) [in] equilibrium -> @equilibrium
  CoordNoun (when|in|at|for) [in] equilibrium -> equilibrium of {CoordNoun}
  (steady-state amplitude|steady amplitude|amplitude in steady state|amplitude of forced (oscillation|oscillations|
      vibration|motion)| amplitude of (steady-state|steady) (oscillation|vibration|motion)) [of Thing] -> @forced
  (phase lag|phase angle|phase difference|phase shift):x [of (Thing|displacement|response|motion)] [(behind|relative to|
      with respect to| between) (force|support|drive|driving force)] -> @forced
  (resonance frequency|resonant frequency|frequency at resonance|resonance angular frequency|driving frequency at
      resonance|frequency of resonance):x [of amplitude] -> @resonance
  (amplitude at resonance|resonant amplitude|resonance amplitude|maximum amplitude of Coord) -> @at_resonance
  point [of|on] [Holder] [that|which] [is] (instantaneously|momentarily) at rest -> instantaneous centre of {Holder}
  (horizontal|vertical):x [component of|part of] Noun -> @lone_component
  (torque|couple|moment|force) (needed|required|that must act|applied) [at|on|to drive|to turn|to move] Thing -> @driving
  damped (natural|angular|circular) (frequency|period):x [of Thing] -> damped {x}
  [(horizontal and vertical|x and y|rectangular)] components of Held -> @held_x
  [(horizontal and vertical|x and y|rectangular)] components of Held -> @held_y
  (static|equilibrium) (elongation|stretch|extension|deflection) [of|in] Spring -> elongation of {Spring} in equilibrium
  (critical damping coefficient|coefficient for critical damping|damping coefficient for critical damping|critical
      damping) -> @critical
  damping factor [of Thing] -> damping ratio
  (lower|lowest|higher|highest|first|second|third):o (frequency|period|natural frequency):x -> @of_mode
  (frequency|period|natural frequency):x (of|in) (lower|lowest|higher|highest|first|second|third):o [normal] mode ->
      @of_mode
  [stable] equilibrium (positions|angles) -> @equilibrium
  (size|magnitude) of State -> magnitude of {State}
  (net|resultant|total) force on Holder -> net force on {Holder}
  (net|resultant|total) torque on Holder [About] -> net torque on {Holder} {About}
  (torque|moment) of Force [on Holder] About -> torque of {Force} on {Holder} {About}
  (elongation|stretch|extension|deflection|deformation) [of|in] Spring -> elongation of {Spring}
  compression [of|in] Spring -> compression of {Spring}
  force (in|of|exerted by|from) Spring -> force {Spring}
  spring force -> spring force
  power (of|delivered by|supplied by|developed by|exerted by) Element -> power of {Element}
  power (of|delivered by|supplied by|developed by|exerted by) Force -> power of {Force}
  power (Does|must) Force (have|deliver|supply|develop|give|exert) -> power of {Force}
  weight -> @weight
  weight of Holder -> weight of {Holder}
  (half|twice|double|one half of|half of):x [of] State -> @multiple
  [angle|position|coordinate|value of] Coord -> {Coord}
  Formula -> {Formula} !1

Swinging
  (period|frequency|circular frequency|angular frequency|natural frequency|natural circular frequency|period of
      oscillation| frequency of oscillation|period of vibration|frequency of vibration|natural period|oscillation
      frequency|oscillation period):x [of [its] [small|free|natural] (oscillations|vibrations|oscillation|swings|motion|
      rocking|rocking motion|amplitudes|amplitude)] -> {x}

Sign
  (magnitude of|size of) -> magnitude of

About
  (about|around|with respect to|relative to) Point -> about {Point}
  (about|around) [its] [own] (centre|center|centre of mass|center of mass|mass centre) -> about its centre of mass

Noun
  (speed|velocity|acceleration|displacement|position):x -> {x}
  (linear|translational) (speed|velocity|acceleration):x -> {x}
  Turns -> {Turns}

RelNoun
  (speed|velocity|acceleration|position|displacement):x -> {x}

Turns
  (angular velocity|angular speed|rate of rotation|rotational speed|spin rate|rotation rate) -> angular velocity
  (angular acceleration|rotational acceleration) -> angular acceleration

Energy
  [total] kinetic energy -> kinetic energy
  (rotational kinetic energy|kinetic energy of rotation|rotational energy) -> rotational kinetic energy
  (translational kinetic energy|kinetic energy of translation) -> translational kinetic energy
  [total] potential energy -> potential energy
  (mechanical energy|total energy|total mechanical energy) -> mechanical energy

Held
  Role (at|on|of|in|from|by|exerted by|due to|under|with|between) Where [on Holder] -> @held
  Role (Does|must|will|can|would) Where Exert [on Holder] -> @held
  Role (Does|must|will|can|would) Body:a Exert on Body:b -> @by_on
  Role (Does|acts|act|is acting) [act] (at|on|in) Where -> @held
  Role (acts|act|is acting) between Body:a and Body:b -> @between
  Role Force -> @named
  Force -> {Force}
  Role on Holder [at|from|by|of|exerted by|due to] [Where] -> @held_on
  Role (that|which|with which) Body:a (exerts|exert|acts|pushes|presses) on Body:b -> @by_on
  Role (of|by|exerted by|from) Body:a (on|exerted on|upon) Body:b -> @by_on
  Role (between|exerted between) [gears|bodies|blocks|balls|wheels|masses|disks|carts|cars|cylinders|boxes] Body:a and
      Body:b -> @between
  Role on Body:b (from|by|exerted by|due to) Body:a -> @by_on
  Role between (gears|teeth|wheels|disks|discs|cylinders|blocks) -> @lone_role
  Role -> @lone_role !2

Role
  [magnitude of|size of] RoleNoun -> {RoleNoun}

Heat
  (heat|energy|mechanical energy|kinetic energy) (produced|dissipated|generated|lost) ->

Does
  (does|do|did) ->

Exert
  (exert|bear|carry|support|have|feel|give|take|apply|sustain) ->

Where
  Contact -> {Contact}
  Element -> {Element}

Gone
  [total] (time|time needed|time required|time taken|time it takes|time interval) (at which|when|until|before|till) Event
      -> time until {Event}
  (time|time needed|time required|time taken|time it takes) [for|to] Event -> time until {Event}
  work done on Holder -> net work on {Holder}
  (energy|heat|mechanical energy|kinetic energy) (dissipated|absorbed|lost|generated|taken up|produced) (by|in|to) Element
      -> @dissipated
  impulse [(of|on|from|exerted by|at|given to|received by|exerted on) Struck] -> @impulse
  (time|time needed|time required|time taken|time interval|elapsed time|duration) [for Subj] -> time
  time [it takes|that it takes|it takes it|taken by it|required] [for] Subj -> time
  (distance|way) Until Event -> @distance_until
  (distance|way|path length) [that] [Subj] (travelled|covered|moved|traveled|slid|rolled|travels|moves|slides|rolls|goes|
      covers|falls|climbs|skids|rises|recoils) [by Thing] [Along] -> @distance
  distance [through which|by which|which|that] Subj (falls|moves|slides|rolls|rises|sinks|descends|travels|goes|drops|has
      moved|climbs) [Along] -> @distance
  angle [turned|rotated|swept] [through] [by Holder] -> @angle
  angular displacement [of Holder] -> @angle
  angle (through|by) which Holder (turns|rotates|swings|has turned|has rotated) -> angle turned by {Holder}
  [total] number of (turns|revolutions|rotations) [of|made by|it makes] [Holder] -> @turns
  work [done] (of|by) Force [on Holder] -> @work
  work Force (does|do|has done) [on Holder] -> @work
  work [done] on Holder by Force -> @work
  work [done] on Holder (by|of) Body -> @work_between
  impulse (of|exerted by) Force -> impulse of {Force}
  impulse (of|exerted by|from|on|in|at|given by) (Unknown|Stranger) [on Body] -> @impulse
  impulse [(that|which) Body exerts] (on|exerted on) Body -> @impulse
  impulse (Does|must) (Body|Where) Exert on Body -> @impulse
  impulse in String -> @impulse
  (impulsive reaction|impulsive force|reactive impulse|impulse of reaction|impulse) (at|of|on|in) (Element|Point)
      [JustAfter|during impact] -> @impulsive
  [total] time (during which|that|for which) Subj (slips|slides|skids|is slipping|is sliding) -> time until {Subj} stops
      slipping
  (maximum|greatest) height [reached|attained] [by Body|it reaches|Body reaches] -> @max_height
  (distance|way) Thing:a (slides|moves|travels|slips|walks|rolls|slid|moved) (on|along|relative to|over|across) Thing:b ->
      @slid
  (maximum|greatest|largest):x angle (of swing|of deflection|of rotation|of oscillation) -> @largest_angle
  Heat [to friction|in friction|in slipping|by friction] -> @heat
  (energy|kinetic energy|mechanical energy) (lost|dissipated) -> energy lost
  amount of (energy|kinetic energy|mechanical energy) (lost|dissipated) -> energy lost
  (loss of|loss in) (energy|kinetic energy|mechanical energy) -> energy lost
  (average|mean) Noun [of Thing] -> average {Noun} of {Thing}
  (change|increase|gain):x (of|in) State -> @change
  (decrease|loss|drop):x (of|in) State -> minus change of {State}
"""

"""The grammar of questions: what a book's words mean in the language of `docs/ask.md`.

A row is “pattern -> meaning” (see `chart`), its further lines set in; a meaning “@name” is a function of MEANINGS in `means`.
What is not said in these words is taken as it is written (`Raw`), at a cost, so that a reading that understands more is
preferred. Marks <1> to <5> say where a clause stands in the language of the engine: phase, moment, function, manner, values.
"""

from __future__ import annotations

QUESTIONS = r"""
Question
  [Ask] (initial|original):x State [Tails] -> {State} at start {Tails}
  [Ask] State [Tails] [FromRest] -> {State} {Tails}
  Moment [,] [Ask] State [Tails] -> {State} <2>{Moment} {Tails}
  [Ask] Gone [Spans] [FromRest] -> {Gone} {Spans}
  Span [,] [Ask] Gone -> {Gone} {Span}
  [Ask] Best State [Spans] -> {Best} {State} {Spans}
  [Ask] Best Noun ReachedBy [Reached] -> {Best} {Noun} of {ReachedBy}
  [Ask] ratio of Pair [on both sides|on two sides] [Tails] -> ratio of {Pair} {Tails}
  [Ask] ratio of [their|two] (speeds|velocities|accelerations|angular velocities|angular accelerations|angular speeds|
      kinetic energies| momenta):n [of Each] [Tails] -> @ratio_each
  [Ask] ratio of [their|two] (speeds|velocities|accelerations|angular velocities|angular accelerations|angular speeds|
      kinetic energies| momenta):n [of Each] [Tails] -> @ratio_other
  [Ask] ratio of State:a (to|and) State:b [Tails] -> ratio of {a} to {b} {Tails}
  [Ask] ratio of Noun of Thing:a (to|and) that of Thing:b [Tails] -> @ratio
  [Ask] ratio of Noun of Thing:a (to|and) Thing:b [Tails] -> @ratio
  [Ask] ratio of Role (on|at|of) Where:a to that (on|at|of) Where:b -> @ratio_held
  [Ask] ratio of Turns of Holder:a to that of Holder:b [Tails] -> ratio of {Turns} of {a} to {Turns} of {b} {Tails}
  [Ask] ratio of Spotted:a (to|and) Spotted:b [Tails] -> ratio of {a} to {b} {Tails}
  [Ask] ratio of (State|Lost) Spot:a (to|and) that Spot:b -> ratio of {State}{Lost} {a} to {State}{Lost} {b}
  [Ask] ratio of Ended:a (to|and) Ended:b State -> ratio of {a} {State} to {b} {State}
  [Ask] difference (between|of) State Moment:a and Moment:b -> @difference
  [Ask] ratio between Noun of Thing:a and Thing:b [Tails] -> @ratio
  [Ask] CoordNoun (at|for) which Event -> {CoordNoun} where {Event}
  [Ask] Stable -> {Stable}
  Ask Raw -> {Raw}
  Asking -> {Asking}
  Condition -> {Condition}

Ask
  what -> !1
  what (is|are|was|were|will be|must be|should be|would be) ->
  (find|determine|calculate|compute|give|express|evaluate|obtain|derive|state) ->
  how (large|big|great|strong|high|long|fast) (is|are|was|will be) ->

Asking
  how fast (is|does|will|do|are|can) Thing [Moving] [Tails] -> speed of {Thing} {Tails}
  how fast (is|does|will|do) Body [be] Turning [Tails] -> angular velocity of {Body} {Tails}
  (with|at) (what|which) (speed|velocity) (is|does|will) Thing (Moving|Turn|Go|move) [Tails] -> speed of {Thing} {Tails}
  (with|at) (what|which) (speed|velocity) (does|will|do) Subj Hit HitWhat -> @strikes
  (with|at) (what|which) (speed|velocity) (does|will|do) Event -> @with_which
  what (speed|velocity|acceleration):x (does|will|has) Thing [have] [Tails] -> {x} of {Thing} {Tails}
  (with|at) (what|which) (Noun|Swinging) (Does|will|is|are) Thing (Moving|Turn|Go|move|Rise|Fall|oscillate|vibrate)
      [Tails] -> {Noun}{Swinging} of {Thing} {Tails}
  (with|at) (what|which) Noun (Does|will) Thing (begin|start) [to] (Stranger|Moving|Turn|Go|move|Rise|Fall) -> {Noun} of
      {Thing} <2>at start
  (with|at) (what|which) [Best] (Par|Chosen) must Subj (pull|push|be pulled|be pushed|turn|be turned|be pressed) (to|for|
      so that|in order that|in order to|if) (Must|Cond) -> {Best} {Par}{Chosen} for which {Must}{Cond}
  where (Does|will) State Still -> where does {State} vanish
  where is Thing (after|at) [time] Coord -> position of {Thing} as a function of {Coord}
  through (what|which) (largest|greatest|maximum):x angle (Does|will|can) Thing (Turn|swing) -> @largest_angle
  to (what|which) height (Does|will|can) Thing (Rise|Go|Turn|fly|jump|bounce) [in all|altogether] -> how high does {Thing}
      rise
  at (what|which) height (Does|will|is) Thing (rest|hang|settle|in equilibrium|float|come to rest) -> height of {Thing} in
      equilibrium
  at (what|which) CoordNoun (Does|will|is) Subj (rest|settle|in equilibrium|come to equilibrium) -> equilibrium of
      {CoordNoun}
  what (angular velocity|angular speed|angular acceleration):x (does|will) Thing [have] [Tails] -> {x} of {Thing} {Tails}
  how far has Thing (moved|gone|travelled|slid|rolled|turned aside|shifted) Moment [Tails] -> magnitude of displacement of
      {Thing} <2>{Moment} {Tails}
  how far [up|down|along] [Ground] (does|will|can|has|do|is) Thing FarVerb [Along] [Spans] -> @far
  how high (does|will|can) Thing (Rise|Go|Turn|swing|go|get|jump|bounce|fly|climb|rise|rebound) [up|above ground] [After]
      -> how high does {Thing} rise {After}
  how long (does it take|will it take|does it last|is it|did it take) (until|before|till|for) Event -> time until {Event}
  how long (does it take|will it take|did it take) Event -> time until {Event}
  how long (does|will) Subj take Event -> time until {Event}
  how far (does|will|can|do) Thing:a FarVerb (on|along|relative to|over|across) Body:b [Until Gripping:e] -> @slid_until
  how (long|much time) (until|before|passes before|elapses before|passes until) Event -> time until {Event}
  after (what|which) time (does|do|will|is|has) Event -> time until {Event}
  (when|at what time|at which time) (does|do|will|is|has) Event -> time until {Event}
  (where|at what point|at which point|at what place|at what position) (does|do|will) Event -> @where
  at (what|which) [value of] CoordNoun (does|do|will|is|has) Event -> {CoordNoun} where {Event}
  (through|by) (what|which) angle (does|will|has) Body Turn [Spans] -> angle turned by {Body} {Spans}
  how many (turns|revolutions|rotations) (does|will|has) Holder (make|makes|made|complete|Turn) [Spans] -> number of
      turns of {Holder} {Spans}
  how long (does|will|did) Subj (slip|slide|skid) -> time until {Subj} stops slipping
  how much (Heat|heat is produced|heat is generated) [to friction|by friction|in slipping] -> @heat
  how much (energy|heat) is (lost|produced|generated|dissipated) [to friction|by friction|in slipping] -> @heat
  how (large|great|big|strong|small) must Par be to (stop|bring):v [Body:b] [to rest] (in|within|after):w Value (turns|
      revolutions| rotations) -> @stopping
  how (large|great|big|strong|small|fast) must (Par|Chosen) be (to|for) Must -> {Par}{Chosen} for which {Must}
  what (Par|Chosen) (makes|causes|will make|lets) Cond -> {Par}{Chosen} for which {Cond}
  what fraction of [its|initial] [kinetic|mechanical] energy is lost [(in|during|by|at|on) BlowNoun:b] -> @fraction
  how fast (does|do) Each (turn|rotate|spin) [Tails] -> angular velocity of {Each} {Tails}
  how fast (does|do) Each (move|go) [Tails] -> speed of {Each} {Tails}
  how much (energy|kinetic energy|mechanical energy) (is|was) lost [Spans] -> energy lost {Spans}
  how much work (does|did|is done by) Force [do] [Spans] -> work of {Force} {Spans}
  how much work is done by Force [Spans] -> work of {Force} {Spans}
  how much does Spring (stretch|extend) [Tails] -> elongation of {Spring} {Tails}
  (does|do|will|can) Condition -> does {Condition}

Condition
  [Ask] [Best] coefficient of [static] friction [needed|required|necessary] [(for|to) Slipless] [SafeMoment] -> {Best} mu
      for which it does not slip {SafeMoment}
  [Ask] [Best] coefficient of [static] friction (needed|required) at Contact -> @rough_at
  [Ask] [minimum] (required|necessary) coefficient of [static] friction [(for|to) Slipless] -> smallest mu for which it
      does not slip
  [Ask] [Best] (friction coefficient|coefficient of friction) (needed|required) -> smallest mu for which it does not slip
  [Ask] Best Chosen [of Body] (ForWhich|needed to|required to|to|needed for) Cond [Given] -> {Best} {Chosen} for which
      {Cond} {Given}
  [Ask] [Best] (Par|Chosen) [needed|required|allowed] (to|for) Must -> {Best} {Par}{Chosen} for which {Must}
  [Ask] Par (needed|required|necessary) to (stop|bring):v [Body:b] [to rest] (in|within|after):w Value (turns|revolutions|
      rotations) -> @stopping
  [Ask] [Best] (Par|Chosen) without Unwanted -> {Best} {Par}{Chosen} for which {Unwanted}
  [Ask] Par (giving|that gives|which gives|for|making) Best State -> @best_of
  [Ask] [Best] Par [of Body] ForWhich Cond [Given] -> {Best} {Par} for which {Cond} {Given}
  [Ask] [Best] Par (needed|required|necessary|to be used) (for|to|so that|that|if) Cond [Given] -> {Best} {Par} for which
      {Cond} {Given}
  [Ask] [Best] Par (that makes|that causes|that lets|that allows|to make|to let|to cause|which makes|that will cause|that
      will make) Cond [Given] -> {Best} {Par} for which {Cond} {Given}
  [Ask] [Best] Par (that|which|that just|that will|to|that can) (keep|keeps|prevent|prevents) Subj (from|in) Kept ->
      {Best} {Par} for which {Subj} {Kept}
  [Ask] [Best] Par (that|which|needed|required|just) [just|will|can] [starts|begins|start] [to|that] (raises|raise|lifts|
      lift|move|moves|start|starts|turn) Thing -> @starts
  [Ask] [Best] Par (to|that|needed to|required to) (prevent|prevents|avoid) (slipping|slip|sliding) -> {Best} {Par} for
      which it does not slip
  [Ask] [Best] Par (to|that|needed to|required to) (prevent|prevents|avoid) (tipping|tip|overturning) -> {Best} {Par} for
      which it does not tip
  (for|at|with) (what|which) [Best] [value|values|range of values] [of] Par (does|do|will|is|are|would|can|has) Cond ->
      {Best} {Par} for which {Cond}
  for (what|which) [Best] [value|values|range of values] [of] Par Cond -> {Best} {Par} for which {Cond}
  what (must|should|would|does|do|will) Par (be|have to be|need to be) (for|so that|such that|if|in order that|to have)
      Cond -> {Par} for which {Cond}
  how (large|great|big|high|long|heavy|strong|small|fast) (must|should|may|can) Par be (for|so that|such that|if|before)
      Cond -> {Par} for which {Cond}
  how (large|great|high|long|heavy|strong|fast) (may|can) (Par|Chosen) [at most] be [at most] (so that|such that|if) Cond
      -> largest {Par}{Chosen} for which {Cond}
  what (value|values) of Par (makes|make|gives|give|will make|will give|would make|lets|causes) Cond -> {Par} for which
      {Cond}
  what [is] Best [value of] Par ForWhich Cond -> {Best} {Par} for which {Cond}

Stable
  condition (that|for which) Resting [of Thing] is stable -> @is_stable
  condition for (stability|stable equilibrium) [of equilibrium|of Thing] -> @is_stable
  (when|where) is equilibrium [of Thing] stable -> @is_stable

Must
  (stay|remain|keep) [in] contact [with Ground] -> it stays in contact
  (stay|remain) on Ground -> it stays in contact
  keep String (taut|tight|stretched) -> tension {String} stays above 0
  (tip|topple|overturn|tip over|tipping) -> it tips
  (slip|slide|start sliding|start slipping|begin to slide) -> it slips
  (Full) -> @full
  (critical damping|be critically damped) -> @critically
  (rolling without slipping|roll without slipping|pure rolling|rolling|prevent slipping|no slipping) -> it does not slip

Unwanted
  (slipping|sliding|skidding|slip) -> it does not slip
  (tipping|overturning|toppling) -> it does not tip
  (slipping|sliding) (or|and) (tipping|toppling|overturning) -> it does not slip
  (slipping|sliding) (or|and) (tipping|toppling|overturning) -> it does not tip
  (losing contact|leaving Ground|lifting off) -> it stays in contact
  (lifting|lifting of|lift-off of) Contact -> {Contact} does not lift

Spotted
  (State|Lost) Spot -> {State}{Lost} {Spot}
  (State|Lost) -> {State}{Lost} !1
  (initial|original):x State -> {State} at start
  final State -> @final

Lost
  (energy|kinetic energy|mechanical energy) (lost|dissipated) -> energy lost
  work done by Force -> work of {Force}

Ended
  final -> final
  (initial|original|starting) -> initial

Spot
  Moment -> {Moment}
  (before|just before|right before|immediately before) [it|this|that] -> @just_before
  (after|just after|right after|immediately after|afterwards) [it|this|that] -> @just_after
  (in|during|at|by) BlowNoun -> @in_impact
  Until Event -> until {Event}

Slipless
  (pure rolling|rolling without slipping|rolling|roll without slipping|prevent slipping|prevent sliding|no slipping|no
      slip| prevent slip) ->

SafeMoment
  Moment -> {Moment}

ForWhich
  (for|at|with|of|by) which [the] ->
  (such|so) that ->
  (that|if|when) ->
  on which ->
  for -> !3

Kept
  (slipping|sliding|skidding|slip) -> does not slip
  (tipping|overturning|toppling) -> does not tip
  (equilibrium|balance) -> is in equilibrium
  (at rest|rest|moving) -> stays at rest

Cond
  Passing -> {Passing}
  Happening -> {Happening}
  (motion|oscillation|system|it|Thing) [is|be|becomes] (critically damped|underdamped|overdamped):x -> @damped
  Subj Not (slip|slide|skid) [Spans] -> {Subj} does not slip {Spans}
  Subj Not (tip|topple|overturn|tip over) -> {Subj} does not tip
  Subj Leave [Ground:g] (at|when|where) Place -> @leaves_at
  (Body|Contact) Not (lift|lift off|leave|rise|bounce|come off) [from|off] [Ground] [Spans] -> {Body}{Contact} does not lift
  State (doubles|is doubled) -> @doubled
  Contact (lifts|lift|lifts off|lift off|leave|leaves) [off] [Ground] -> {Contact} vanishes
  Subj Not (leave|lose contact with|lift off|lift from|fly off) [Ground] [Spans] -> {Subj} stays in contact {Spans}
  Subj (stays|stay|remains|remain|keeps) [in] contact [with Ground] [Spans] -> {Subj} stays in contact {Spans}
  Subj (stays|stay|remains|remain|keeps) on Ground [Spans] -> {Subj} stays in contact {Spans}
  Subj Nearly (slip|slide|move|skid|slipping|sliding|skidding|moving|slips|slides) -> {Subj} slips
  Subj Nearly (tip|tips|tipping|overturn|overturning|topple|toppling|tip over|tipping over) -> {Subj} tips
  Subj Nearly (lift|lifting|leave|leaving|lose contact with|losing contact with|lift off|lifting off|rise|rising) [from]
      [Ground] -> {Subj} lifts
  (slipping|sliding|slip) (is|impends) [impending|imminent] -> it slips
  tipping (is|impends) [impending|imminent] -> it tips
  Subj (can stand|stands|can rest|can be in equilibrium|is safe|stays in place|stays put) -> {Subj} stays at rest
  Subj (stays|stay|remains|remain|is|be|are) (at rest|in equilibrium|balanced) -> {Subj} stays at rest
  Subj (does not|do not|will not|not|to not|never) (move|start moving|begin to move|start to move) -> {Subj} stays at rest
  String (stays|remains|is|stay|remain|is kept) (taut|tight) [Spans] -> tension {String} stays above 0 {Spans}
  String Not (go slack|become slack|slacken) [Spans] -> tension {String} stays above 0 {Spans}
  Subj Rolls (without slipping|without sliding|purely) -> {Subj} does not slip
  (rolling|it rolls|pure rolling) (occurs|without slipping|is possible|without slipping is possible) -> it does not slip
  (there is no|no|without any) (slipping|sliding|slip) [occurs] -> it does not slip
  Subj (comes to rest|stops|is brought to rest|come to rest) (at|when|where) Coord (=|is|reaches) Value -> {Coord} comes
      to rest at {Coord} = {Value}
  Subj Full -> @full
  Resting [of Thing] (is|be) (stable|unstable):x -> @stable
  (upright|vertical):u position (is|be) (stable|unstable):x -> @upright
  Subj neither (slips|slides|slip|slide) nor (tips|topples|overturns|tip|tips over|topple) -> {Subj} does not slip
  Subj neither (slips|slides|slip|slide) nor (tips|topples|overturns|tip|tips over|topple) -> {Subj} does not tip
  (Element|Force) Not (break|snap|give way|fail) -> @holds_out
  Subj (stops dead|is stopped dead|is at rest after it|is stopped by Unknown) -> velocity of {Subj} right after impact
      vanishes
  Subj (stops|is stopped|comes to rest) (in|after|within):w Value (turns|revolutions|rotations) -> @stops_in
  State Still [BlowMoment] -> {State} {BlowMoment} vanishes
  Contact (bears|bear|carries|carry) no (load|force|weight) -> {Contact} vanishes
  Subj (is|be|are|comes|remains|stops) [at rest|to rest] BlowMoment -> velocity of {Subj} {BlowMoment} vanishes
  Subj (Rolls|Go|moves) (with|at) constant (speed|velocity) -> acceleration of {Subj} vanishes
  Subj (rotates|turns|spins) (with|at) constant (speed|angular velocity|angular speed|rate) -> angular acceleration of
      {Subj} vanishes
  Contact (stays|remains|stay|remain|Not leave|Not lift off) [on|in contact with] Ground -> {Contact} does not lift
  State Not (fall|drop|decrease|go) below Value -> {State} stays above {Value}
  State Not (exceed|rise above|grow beyond|go above) Value -> {State} stays below {Value}
  State:a Cmp State:b [Tails] -> {a} {Cmp} {b} {Tails}
  State:a Cmp Value [Tails] -> {a} {Cmp} {Value} {Tails}
  State:a and State:b (are|become|is) (equal|same|equal in magnitude|of equal magnitude) [Tails] -> {a} = {b} {Tails}
  State:a (does not depend on|is independent of) Par -> {a} does not depend on {Par}
  State (is|becomes|be|are) Top -> {State} is {Top}
  (there is no|no) State [Tails] -> {State} vanishes {Tails}
  Raw -> {Raw}

Resting
  equilibrium [position] ->

Still
  (vanishes|is zero|is nil|disappears) ->

BlowMoment
  (JustAfter|after) BlowNoun -> right after impact

Full
  [Aux] (make|makes|making|complete|completes|completing|perform|performs|describe|describes) (full|complete|whole|entire|
      one full|one complete) (circle|loop|turn|revolution|circles|revolutions|rotation) ->
  [Aux] (complete|completes) (circle|loop) ->
  [Aux] (go|goes) (all way round|full circle|right round|over top) ->

Not
  (does not|do not|will not|cannot|can not|never|not|to not|not to|just does not|must not|should not|would not) [begin to|
      start to|just|quite] ->

Nearly
  [Aux] (just|first|nearly|almost) ->
  (is|are|be|being) (about to|on point of|on verge of|at point of|ready to) [start|begin] ->
  (just|first|to|would|will|just) (begins|begin|starts|start|about) to ->
  (begins|begin|starts|start|to begin|to start) to ->
  (begins|begin|starts|start) ->
  to (just|first) ->

Rolls
  (rolls|roll|to roll|rolling|will roll|rolled) ->

Cmp
  (=|equals|is equal to|becomes equal to|be equal to) -> =
  (is|becomes|reaches|be|has reached|are) -> =
  (>=|is at least|is not less than) -> >=
  (<=|is at most|does not exceed|is not more than|is not greater than|not exceed|not to exceed) -> <=
  (>|exceeds|is greater than|is more than|is larger than) -> >
  (<|is less than|is smaller than) -> <
  (is|equals|becomes|has fallen to|falls to|drops to|has dropped to|has been reduced to|is reduced to|has increased to|has
      decreased to) -> =

Best
  (largest|greatest|maximum|highest|maximal|steepest) [possible|allowable|permissible|safe] -> largest
  (smallest|least|minimum|lowest|minimal) [possible|allowable|required|necessary] -> smallest
  longest -> longest
  shortest -> shortest

Top
  (largest|greatest|maximum|highest|a maximum|maximal|as large as possible|as great as possible) -> largest
  (smallest|least|minimum|lowest|a minimum|minimal|as small as possible) -> smallest

ReachedBy
  (reached|attained|acquired|achieved|experienced) by Thing -> {Thing}
  [that|which] Thing (reaches|attains|acquires|gets|has|achieves|will reach|will attain|experiences) -> {Thing}

Reached
  (reached|attained|achieved) ->
  (during|in|throughout|over) [whole|entire|subsequent|resulting|its|ensuing] (motion|swing|movement) ->
"""

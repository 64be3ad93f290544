"""The grammar of questions: what a book's words mean in the language of `docs/ask.md`.

A row is “pattern -> meaning” (see `chart`); a meaning “@name” is a function of MEANINGS in `means`. What is not said in these words is
taken as it is written (`Raw`), at a cost, so that a reading that understands more is preferred. Marks <1> to <5> say where a clause
stands in the language of the engine: phase, moment, function, manner, values.
"""

from __future__ import annotations

RULES = r"""
Question
  [Ask] State [Tails] -> {State} {Tails}
  Moment [,] [Ask] State [Tails] -> {State} <2>{Moment} {Tails}
  [Ask] Gone [Spans] -> {Gone} {Spans}
  Span [,] [Ask] Gone -> {Gone} {Span}
  [Ask] Best State [Spans] -> {Best} {State} {Spans}
  Best State Reached -> {Best} {State}
  [Ask] ratio of State:a (to|and) State:b [Tails] -> ratio of {a} to {b} {Tails}
  [Ask] ratio of Noun of Thing:a (to|and) (that|Noun:other) of Thing:b [Tails] -> @ratio
  [Ask] ratio of Noun of Thing:a (to|and) Thing:b [Tails] -> @ratio
  [Ask] ratio of Role (on|at|of) Where:a to that (on|at|of) Where:b -> @ratio_held
  [Ask] ratio of Turns of Holder:a to that of Holder:b [Tails] -> ratio of {Turns} of {a} to {Turns} of {b} {Tails}
  [Ask] difference (between|of) State Moment:a and Moment:b -> @difference
  [Ask] ratio between Noun of Thing:a and Thing:b [Tails] -> @ratio
  Ask Raw -> {Raw}
  Asking -> {Asking}
  Condition -> {Condition}

Ask
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
  what (angular velocity|angular speed|angular acceleration):x (does|will) Thing [have] [Tails] -> {x} of {Thing} {Tails}
  how far (does|will|can|has|do|is) Thing FarVerb [Along] [Spans] -> distance travelled by {Thing} {Spans}
  how high (does|will|can) Thing (Rise|Go|Turn|swing|go|get|jump|bounce|fly|climb|rise|rebound) [up|above ground] [After] -> how high does {Thing} rise {After}
  how long (does it take|will it take|does it last|is it|did it take) (until|before|till|for) Event -> time until {Event}
  how long (does it take|will it take|did it take) Event -> time until {Event}
  how long (does|will) Subj take Event -> time until {Event}
  how (long|much time) (until|before|passes before|elapses before|passes until) Event -> time until {Event}
  after (what|which) time (does|do|will|is|has) Event -> time until {Event}
  (when|at what time|at which time) (does|do|will|is|has) Event -> time until {Event}
  (where|at what point|at which point|at what place|at what position) (does|do|will) Event -> @where
  at (what|which) [value of] CoordNoun (does|do|will|is|has) Event -> {CoordNoun} where {Event}
  (through|by) (what|which) angle (does|will|has) Body Turn [Spans] -> angle turned by {Body} {Spans}
  how many (turns|revolutions|rotations) (does|will|has) Body (make|makes|made|complete|Turn) [Spans] -> number of turns of {Body} {Spans}
  how much (energy|heat|kinetic energy|mechanical energy) (is|was) (lost|dissipated|converted into heat|generated) [Spans] -> energy lost {Spans}
  how much work (does|did|is done by) Force [do] [Spans] -> work of {Force} {Spans}
  how much work is done by Force [Spans] -> work of {Force} {Spans}
  how much does Spring (stretch|extend) [Tails] -> elongation of {Spring} {Tails}
  (does|do|will|can) Condition -> does {Condition}

Condition
  [Ask] Best coefficient of [static] friction [needed|required] [(for|to) Slipless] [between Raw] [SafeMoment] -> smallest mu for which it does not slip {SafeMoment}
  [Ask] [Best] Par ForWhich Cond [Given] -> {Best} {Par} for which {Cond} {Given}
  [Ask] [Best] Par (needed|required|necessary|to be used) (for|to|so that|that|if) Cond [Given] -> {Best} {Par} for which {Cond} {Given}
  [Ask] [Best] Par (that makes|that causes|that lets|that allows|to make|to let|to cause|which makes|that will cause|that will make) Cond [Given] -> {Best} {Par} for which {Cond} {Given}
  [Ask] [Best] Par (that|which|that just|that will|to|that can) (keep|keeps|prevent|prevents) Subj (from|in) Kept -> {Best} {Par} for which {Subj} {Kept}
  [Ask] [Best] Par (to|that|needed to|required to) (prevent|prevents|avoid) (slipping|slip|sliding) -> {Best} {Par} for which it does not slip
  [Ask] [Best] Par (to|that|needed to|required to) (prevent|prevents|avoid) (tipping|tip|overturning) -> {Best} {Par} for which it does not tip
  (for|at|with) (what|which) [Best] [value|values|range of values] [of] Par (does|do|will|is|are|would|can|has) Cond -> {Best} {Par} for which {Cond}
  for (what|which) [Best] [value|values|range of values] [of] Par Cond -> {Best} {Par} for which {Cond}
  what (must|should|would|does|do|will) Par (be|have to be|need to be) (for|so that|such that|if|in order that|to have) Cond -> {Par} for which {Cond}
  how (large|great|big|high|long|heavy|strong|small|fast) (must|should|may|can) Par be (for|so that|such that|if|before) Cond -> {Par} for which {Cond}
  what (value|values) of Par (makes|make|gives|give|will make|will give|would make|lets|causes) Cond -> {Par} for which {Cond}
  what [is] Best [value of] Par ForWhich Cond -> {Best} {Par} for which {Cond}

Slipless
  (pure rolling|rolling without slipping|rolling|roll without slipping|prevent slipping|prevent sliding|no slipping|no slip|prevent slip) ->
SafeMoment
  Moment -> {Moment}

ForWhich
  (for|at|with|of|by) which [the] ->
  (such|so) that ->
  (that|if|when) ->
  for -> !3

Kept
  (slipping|sliding|skidding|slip) -> does not slip
  (tipping|overturning|toppling) -> does not tip
  (equilibrium|balance) -> is in equilibrium
  (at rest|rest|moving) -> stays at rest

Cond
  Event -> {Event}
  Subj Not (slip|slide|skid) [Spans] -> {Subj} does not slip {Spans}
  Subj Not (tip|topple|overturn|tip over) -> {Subj} does not tip
  Subj Not (leave|lose contact with|lift off|lift from|fly off) [Ground] [Spans] -> {Subj} stays in contact {Spans}
  Subj (stays|stay|remains|remain|keeps) [in] contact [with Ground] [Spans] -> {Subj} stays in contact {Spans}
  Subj (stays|stay|remains|remain|keeps) on Ground [Spans] -> {Subj} stays in contact {Spans}
  Subj Nearly (slip|slide|move|skid|slipping|sliding|skidding|moving|slips|slides) -> {Subj} slips
  Subj Nearly (tip|tips|tipping|overturn|overturning|topple|toppling|tip over|tipping over) -> {Subj} tips
  Subj Nearly (lift|lifting|leave|leaving|lose contact with|losing contact with|lift off|lifting off|rise|rising) [from] [Ground] -> {Subj} lifts
  (slipping|sliding|slip) (is|impends) [impending|imminent] -> it slips
  (tipping|motion) (is|impends) [impending|imminent] -> it slips
  Subj (stays|stay|remains|remain|is|be|are) (at rest|in equilibrium|balanced) -> {Subj} stays at rest
  Subj (does not|do not|will not|not|to not|never) (move|start moving|begin to move|start to move) -> {Subj} stays at rest
  Subj Rolls (without slipping|without sliding|purely) -> {Subj} does not slip
  (rolling|it rolls|pure rolling) (occurs|without slipping|is possible|without slipping is possible) -> it does not slip
  (there is no|no|without any) (slipping|sliding|slip) [occurs] -> it does not slip
  Subj (comes to rest|stops|is brought to rest|come to rest) (at|when|where) Coord (=|is|reaches) Value -> {Coord} comes to rest at {Coord} = {Value}
  Subj Full -> @full
  equilibrium [position] [of Thing] (is|be) (stable|unstable):x -> @stable
  State Not (fall|drop|decrease|go) below Value -> {State} stays above {Value}
  State Not (exceed|rise above|grow beyond|go above) Value -> {State} stays below {Value}
  State:a Cmp State:b [Tails] -> {a} {Cmp} {b} {Tails}
  State:a Cmp Value [Tails] -> {a} {Cmp} {Value} {Tails}
  State:a and State:b (are|become|is) (equal|same|equal in magnitude|of equal magnitude) [Tails] -> {a} = {b} {Tails}
  State:a (does not depend on|is independent of) Par -> {a} does not depend on {Par}
  State (is|becomes|be|are) Top -> {State} is {Top}
  (there is no|no) State [Tails] -> {State} vanishes {Tails}
  Raw -> {Raw}

Full
  [Aux] (make|makes|making|complete|completes|completing|perform|performs|describe|describes) (full|complete|whole|entire|one full|one complete) (circle|loop|turn|revolution|circles|revolutions|rotation) ->
  [Aux] (complete|completes) (circle|loop) ->
  [Aux] (go|goes) (all way round|full circle|right round|over top) ->

Not
  (does not|do not|will not|cannot|can not|never|not|to not|not to|just does not|must not|should not|would not) [begin to|start to|just|quite] ->

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
  (is|equals|becomes|has fallen to|falls to|drops to|has dropped to|has been reduced to|is reduced to|has increased to|has decreased to) -> =

Best
  (largest|greatest|maximum|highest|maximal) [possible|allowable|permissible|safe] -> largest
  (smallest|least|minimum|lowest|minimal) [possible|allowable|required|necessary] -> smallest
  longest -> longest
  shortest -> shortest

Top
  (largest|greatest|maximum|highest|a maximum|maximal|as large as possible|as great as possible) -> largest
  (smallest|least|minimum|lowest|a minimum|minimal|as small as possible) -> smallest

Reached
  (reached|attained|acquired|achieved|experienced) [by Subj] ->
  [that|which] Subj (reaches|attains|acquires|gets|has|achieves|will reach|will attain|experiences) ->
  (during|in|throughout|over) [whole|entire|subsequent|resulting|its|ensuing] (motion|swing|movement) ->

Tails
  Tail [,] [Tails] -> {Tail} {Tails}

Tail
  Moment -> <2>{Moment}
  (as [a] function of|in terms of|as functions of|by) Arg -> <3>as a function of {Arg}
  (in|during) phase Phase -> <1>in phase {Phase}
  (for|in|under|in case of) small (oscillations|swings|vibrations|displacements|amplitudes) -> <4>for small oscillations
  (for|if|when|in case of) [it is|Thing is] (critically damped|critical damping|underdamped|overdamped):x -> <4>{x}
  (when|if) (damping is critical|critical damping) -> <4>critically damped
  Given -> <5>{Given}

Arg
  Coord -> {Coord}
  time -> t
  Par -> {Par}
  (state|positions and speeds|position and speed) -> state
  (speed|velocity) of Coord -> speed of {Coord}

Given
  (with|if|when|where|for|given|taking|at) Par (=|is) Value [Givens] -> with {Par} = {Value}{Givens}
Givens
  [,|and] Par (=|is) Value [Givens] -> , {Par} = {Value}{Givens}

Moment
  At (start|beginning|first|outset|release|moment of release|instant of release|start of motion|beginning of motion|instant it is released|moment it is released|very start|very beginning) -> at start
  (initially|at first|just after release|right after release|immediately after release|shortly after release|on release|upon release|at release|when released|just after it is released) -> at start
  [JustAfter|when|as soon as|once|at instant|at moment|instant|moment] Subj (is|are|has been|was) (released|let go|set free) [from rest] [from Raw] -> at start
  (at|in) its (initial|starting) position -> at start
  When Event -> where {Event}
  When Begin -> when {Begin} begins
  When BeginClause -> when {BeginClause} begins
  JustBefore Event -> where {Event}
  JustBefore (Begin|Blow):x [Begins] -> just before {x}
  JustBefore BeginClause -> just before {BeginClause}
  JustAfter (Begin|Blow):x [Begins] -> right after {x}
  after (Begin|Blow):x [Begins] -> right after {x}
  JustAfter BeginClause -> right after {BeginClause}
  after BeginClause -> right after {BeginClause}
  JustAfter Event -> where {Event}
  after Event -> where {Event}
  before (Blow|BlowNoun):x -> just before {x}
  JustBefore BlowNoun -> just before impact
  (JustAfter|after) BlowNoun -> right after impact
  (just before|right before|immediately before|just after|right after|immediately after|before|after):side Subj Hit HitWhat -> @blow
  When Subj (first|) Hit HitWhat -> @blow
  At Place -> where {Place}
  on (hitting|striking) HitWhat -> @blow
  (at|in|for) [its|position of] [stable] (equilibrium|rest|equilibrium position|equilibrium configuration|rest position) -> in equilibrium
  (at|in) [its|position of] unstable (equilibrium|equilibrium position) -> in unstable equilibrium
  At [its] (lowest|bottom):x (point|position|place) [of [its] (path|swing|motion|arc|track|loop|circle|hill|dip)] -> at its lowest point
  At [its] (highest|top|uppermost):x (point|position|place) [of [its] (path|swing|motion|arc|track|loop|circle|hill)] -> at its highest point
  At bottom [of [its] (path|swing|motion|arc|track|loop|circle|bowl|dip|trough)] -> at bottom
  At top [of [its] (path|swing|motion|arc|track|loop|circle|hill)] -> at top
  When Subj [Aux] (is in|is at|in|reach|reaches|pass|passes|passes through|is passing through|reaches its|passes its|goes through|is passing) [its|through] (lowest|bottom) [point|position|place] [of [its] (path|swing|motion|arc|track|loop|circle)] -> where {Subj} is at its lowest point
  When Subj [Aux] (is in|is at|in|reach|reaches|pass|passes|passes through|is passing through|goes through|is passing) [its|through] (highest|uppermost|top) [point|position|place] [of [its] (path|swing|motion|arc|track|loop|circle)] -> where {Subj} is at its highest point
  At [its] turning point [of Coord] -> at turning point
  At end of (phase Phase|Phase) -> at end of phase {Phase}
  after Elapsed -> {Elapsed}

Elapsed
  [a] [time] [of] Time -> where t = {Time}
  Value (turns|revolutions|rotations|turn|revolution) [of Body] -> after {Value} turns
  a fall of Value -> where it has fallen {Value}
  (falling|descending|dropping) [through] [a (distance|height) [of]] Value -> where it has fallen {Value}

At
  (at|in|from|for|with it at) [moment of|instant of|point of] ->
  at [the] ->

When
  (when|where|if|once|as|while|as soon as|at instant|at instant when|at instant that|at moment|at moment when|at moment that|at point where|at time|at time when|just as|just when|the moment|the instant|by time|at which|at position where|at place where|for position where|at instant at which) [first] ->
JustBefore
  (just|right|immediately|shortly|directly|an instant|the instant) (before|prior to) ->
JustAfter
  (just|right|immediately|shortly|directly|an instant) after ->
  as soon as ->
Begins
  (begins|starts|has begun|sets in|begin) ->
BeginClause
  (Element|It|Contact):who Cut -> @cut

Aux
  (has|have|had|has just|have just|just|will|first|has first|to|can|would|could|next|again|is just|does|do|did|may|must|finally|momentarily|to just|will just|just has|is|are|be|being|in|on|by|will have|first has) ->

BlowNoun
  (impact|collision|blow|bounce|it is struck|striking|hit) ->

HitWhat
  (Body|Ground|Point):x -> {x}

Event
  Coord [Aux] (=|is|reaches|equals|becomes|reach|has reached|has value|reaches value|is equal to|be|to be|has become) Value -> {Coord} = {Value}
  [angle|position] Coord = Value -> {Coord} = {Value}
  Subj Reach Place -> {Place}
  Subj (at|is at) Place -> {Place}
  State (=|is|reaches|equals|becomes|has fallen to|has dropped to|falls to|drops to|has risen to|is reduced to|is equal to|has decreased to|has increased to) Value -> {State} = {Value}
  State:a (=|is|reaches|equals|becomes|is equal to) State:b -> {a} = {b}
  State (is|becomes|reaches its) Top -> {State} is {Top}
  Subj (has|have|with|reaches|attains|acquires|gets|have reached|has reached|is moving at|is moving with|moves with|moves at|to reach|to attain|reaching|to have|moves with a|travels at) [a|its] [speed|velocity] [of] SpeedValue -> @speed
  Subj (has|have|with|reaches|attains|acquires|gets|have reached|has reached|to reach|to attain|reaching|to have|rotates at|turns at|turns with) [its] (angular velocity|angular speed|speed) [of] TurnValue -> angular velocity of {Subj} = {TurnValue}
  [Subj] Stop [again|momentarily|completely|for first time|instantaneously] -> @rests
  [Subj] Return [to (its|start|starting|initial|where|original)] [start|point|position|starting point|starting position|place|it started] -> {Subj} comes back
  [Subj] Fall [down|by|through] [a|its] [(distance|height|depth|way)] [of] Length -> {Subj} has fallen {Length}
  [Subj] Rise [up|by|through] [a] [(distance|height)] [of] Length -> {Subj} has risen {Length}
  [Subj] Go [down|up|by|through|along] [a|its] [(distance|way|length)] [of] Length [Along] -> {Subj} has moved {Length}
  [Subj] Turn [through|by|around] [an|a] [angle] [of] Angle -> {Subj} has turned {Angle}
  [Subj] [Aux] (made|make|makes|making|complete|completed|completes|Turn) Value (turns|revolutions|rotations|full turns) -> {Subj} has turned 2*pi*({Value})
  [Subj] [Aux] (made|make|makes|making|complete|completed|completes) (one|a|one full|a full|a complete|one complete) (turn|revolution|rotation) -> {Subj} has turned 2*pi
  [Subj] [Aux] Leave [Ground:g|Body:g|Point:g] -> @leaves
  String [Aux] (goes slack|becomes slack|go slack|become slack|is slack|slackens) -> {String} goes slack
  Held (vanishes|is lost|vanish|is zero|becomes zero|drops to zero|falls to zero) -> @vanishes
  (contact|it) [Aux] (is lost|ceases|loses contact) -> contact is lost
  [Subj] (stops|stop|ceases|cease|no longer|has stopped) (slipping|sliding|slips|slides|skidding|to slip|to slide|skids) -> {Subj} stops slipping
  (slipping|sliding|slip|skidding) (stops|ceases|ends|has ceased|has stopped) -> it stops slipping
  [Subj] (begins|starts|begin|start|has begun|has started|beginning|starting|to begin|to start) (rolling|to roll|pure rolling) [without slipping|purely] -> {Subj} stops slipping
  [Subj] (rolls|roll|rolling|is rolling|to roll) (without slipping|without sliding|purely) -> {Subj} stops slipping
  (rolling|pure rolling|rolling without slipping) (begins|starts|sets in|has begun|occurs) -> it stops slipping
  [Subj] (begins|starts|begin|start|to begin|to start|just begins|first begins|beginning|starting) (to slip|to slide|slipping|sliding|to skid) -> {Subj} slips
  [Subj] (slips|slip) -> {Subj} slips
  [Subj] [Aux] Tip -> {Subj} tips
  Subj (is|becomes|are|gets|has become|be|being|to be) (vertical|horizontal):x -> {Subj} is {x}
  Subj (makes|makes an angle of|forms|makes an angle|is inclined at|is at) [an angle of] Value [degrees|deg]:d (with|to|from) [the] (vertical|horizontal):x -> {Subj} makes {Value} {d} with {x}
  [Subj] (is in|in|to) [a] (vertical|horizontal):x position -> {Subj} is {x}
  Body:a (catches|overtakes|reaches|catches up with|meet|meets|catch|overtake|passes) Body:b -> {a} meets {b}
  Body:a and Body:b (meet|pass|are level|are side by side|collide|are at same height|are at same level) -> {a} meets {b}
  Body:a and Body:b (have|turn with|rotate with|turn at|rotate at) (same|equal|a common) angular (velocity|speed|velocities|speeds) -> {a} and {b} have same angular velocity
  Spring [Aux] (reaches|is at|has|regains|returns to|attains) [its] (natural|unstretched|free|original|undeformed|relaxed) length -> {Spring} is unstretched
  Spring [Aux] (is|becomes|gets) (relaxed|unstretched|unstressed|undeformed|slack|uncompressed) -> {Spring} is unstretched
  Spring (is|has) (most compressed|maximum compression|its maximum compression|fully compressed|compressed most) -> compression of {Spring} is largest
  Spring (is|has) (most stretched|maximum extension|its maximum extension|stretched most|fully stretched) -> elongation of {Spring} is largest
  Spring (is|has been) (compressed|stretched|extended):c by Length -> @stretched
  Subj (is|are|be) (moving|going|sliding|turning|rolling) (fastest|most quickly) -> speed of {Subj} is largest

Place
  Coord [=|of] Value -> {Coord} = {Value}
  [its] (lowest|bottom) (point|position) -> it is at its lowest point
  [its] (highest|top) (point|position) -> it is at its highest point
  [its] [stable] (equilibrium|equilibrium position|position of equilibrium) -> it is in equilibrium !2

Spans
  Span [,] [Spans] -> {Span} {Spans}
  Given -> <5>{Given}
Span
  Until Event -> <2>until {Event}
  Until (Begin|Blow|Phase):x [Begins] -> <2>until {x}
  Until BeginClause -> <2>until {BeginClause}
  from (start|rest|release|beginning) (to|until|till|up to) [where|when|moment when|instant when|moment|instant] Event -> <2>until {Event}
  between (start|release) and [moment when|instant when|where|when] Event -> <2>until {Event}
  (in|during) Gerund -> <2>until {Gerund}
  (during|in|over|throughout) (phase Phase|Phase) -> <1>in phase {Phase}
  (during|in|by|due to|at) (collision|impact|blow|bounce) -> <2>in impact
  Reached ->
  (as [a] function of|in terms of) Arg -> <3>as a function of {Arg}
  after (Begin|Blow|BlowNoun):x -> <2>after {x}
  At start -> <2>at start
  over Par -> <2>over {Par}
  over Par between Value:a and Value:b -> <2>over {Par} between {a} and {b}
  (from|between) Coord:c [=] Value:a (to|and) [Coord] [=] Value:b -> <2>from {c} = {a} to {c} = {b}
Until
  (until|till|up to|before|by time|by time that|when|once|to|in|for|at instant|as|upto|until moment when|until it|by moment|while|after|for it|up to where|by instant) [where|when|moment|instant] ->
Gerund
  Event -> {Event}
After
  [JustAfter|after|on] BlowNoun -> after impact
  after (Blow|Begin):x -> after {x}
Along
  (up|down|along|on|over|across|upwards|downwards|forward|forwards|back|backwards|horizontally|vertically|out|away) [on|along] [Ground|incline|slope|plane|hill|ramp|table|floor] ->
FarVerb
  (go|move|slide|roll|travel|climb|rise|fall|drop|get|advance|gone|moved|slid|travelled|driven|pushed|recoil|descend|sink|drop|skid) ->
Moving
  (moving|going|sliding|rolling|travelling|traveling|falling|rising|move|go|slide|roll|travel|swing|fall|rise|be moving|then moving|be going) ->
Turning
  (turning|rotating|spinning|turn|rotate|spin|swinging) ->

Thing
  Point -> {Point}
  Body -> {Body}
  Coord -> {Coord}
  It -> {It}
Subj
  Body -> {Body}
  Coord -> {Coord}
  Point -> {Point} !1
  It -> {It}
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
  Noun -> {Noun} !2
  RelNoun of Thing:a (relative to|with respect to|as seen from|seen from) Thing:b -> @relative
  relative RelNoun of Thing:a (and|to) Thing:b -> @relative
  (speed|velocity) with which Event -> @with_which
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
  angular momentum [of (Holder|system):x] [About] -> angular momentum of {x} {About}
  moment of inertia [of (Holder|system):x] [About] -> moment of inertia of {x} {About}
  radius of gyration [of (Holder|system):x] [About] -> radius of gyration of {x} {About}
  instantaneous (centre|center) [of rotation|of velocity|of zero velocity] of Holder -> instantaneous centre of {Holder}
  distance (from|between) Point:a (to|and) Point:b -> distance from {a} to {b}
  height of Thing [above Ground] -> height of {Thing}
  Held -> {Held}
  (horizontal|vertical):x [component of|part of] Held -> @component
  (horizontal|vertical):x [component of|part of] Noun of Thing -> {x} component of {Noun} of {Thing}
  (direction|angle) of Held -> direction of {Held}
  (size|magnitude) of State -> magnitude of {State}
  (net|resultant|total) force on Holder -> net force on {Holder}
  (net|resultant|total) torque on Holder [About] -> net torque on {Holder} {About}
  (torque|moment) of Force [on Holder] About -> torque of {Force} on {Holder} {About}
  (elongation|stretch|extension) [of|in] Spring -> elongation of {Spring}
  compression [of|in] Spring -> compression of {Spring}
  force (in|of|exerted by|from) Spring -> force {Spring}
  spring force -> spring force
  power (of|delivered by|supplied by|developed by|exerted by) Force -> power of {Force}
  weight -> @weight
  weight of Holder -> weight of {Holder}
  (half|twice|double|one half of|half of):x [of] State -> @multiple
  [angle|position|coordinate|value of] Coord -> {Coord}
  Formula -> {Formula} !1

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
  Role Force -> @named
  Force -> {Force}
  Role on Holder [at|from|by|of|exerted by|due to] [Where] -> @held_on
  Role (that|which|with which) Body:a (exerts|exert|acts|pushes|presses) on Body:b -> @between
  Role (of|by|exerted by|from) Body:a (on|exerted on|upon) Body:b -> @between
  Role (between|exerted between) [gears|bodies|blocks|balls|wheels|masses|disks|carts|cars|cylinders|boxes] Body:a and Body:b -> @between
  Role on Body:b (from|by|exerted by|due to) Body:a -> @between
  Role -> {Role} !2
Role
  [magnitude of|size of] RoleNoun -> {RoleNoun}
Where
  Contact -> {Contact}
  Element -> {Element}

Gone
  (time|time needed|time required|time taken|time it takes) [for|to] Event -> time until {Event}
  work done on Holder -> net work on {Holder}
  (energy|heat|mechanical energy|kinetic energy) (dissipated|absorbed|lost|generated|taken up|produced) (by|in|to) Element -> @dissipated
  impulse [(of|on|from|exerted by|at|given to|received by|exerted on) Struck] -> @impulse
  (time|time needed|time required|time taken|time interval|elapsed time|duration) [for Subj] -> time
  time [it takes|that it takes|it takes it|taken by it|required] [for] Subj -> time
  (distance|way|path length) [that] [Subj] (travelled|covered|moved|traveled|slid|rolled|travels|moves|slides|rolls|goes|covers|falls|climbs|skids|rises|recoils) [by Thing] [Along] -> @distance
  distance [through which|by which|which|that] Subj (falls|moves|slides|rolls|rises|sinks|descends|travels|goes|drops|has moved|climbs) [Along] -> @distance
  angle [turned|rotated|swept] [through] [by Holder] -> @angle
  angle (through|by) which Holder (turns|rotates|swings|has turned|has rotated) -> angle turned by {Holder}
  number of (turns|revolutions|rotations) [of|made by|it makes] [Holder] -> @turns
  work [done] (of|by) Force [on Holder] -> @work
  work Force (does|do|has done) [on Holder] -> @work
  work [done] on Holder by Force -> @work
  work [done] on Holder (by|of) Body -> @work_between
  impulse (of|exerted by) Force -> impulse of {Force}
  (energy|kinetic energy|mechanical energy) (lost|dissipated) -> energy lost
  (loss of|loss in) (energy|kinetic energy|mechanical energy) -> energy lost
  (heat|energy) (generated|produced|dissipated|converted to heat) [by|in|to] [friction] -> energy lost
  (average|mean) Noun [of Thing] -> average {Noun} of {Thing}
  (change|increase|gain):x (of|in) State -> @change
  (decrease|loss|drop):x (of|in) State -> minus change of {State}
"""

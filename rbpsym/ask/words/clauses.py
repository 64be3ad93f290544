"""The clauses of questions (see `questions`): moments, spans of the motion, what happens in it."""

from __future__ import annotations

CLAUSES = r"""
Tails
  Tail [,] [Tails] -> {Tail} {Tails}

Tail
  Moment -> <2>{Moment}
  (as [a] function of|in terms of|as functions of|by) Arg -> <3>as a function of {Arg}
  (in|during) phase Phase -> <1>in phase {Phase}
  (if|when) Subj (is|are) (critically damped|underdamped|overdamped):x -> <4>{x}
  (for|in|under|in case of) small (oscillations|swings|vibrations|displacements|amplitudes) -> <4>for small oscillations
  (for|if|when|in case of) [it is|Thing is] (critically damped|critical damping|underdamped|overdamped):x -> <4>{x}
  (when|if) (damping is critical|critical damping) -> <4>critically damped
  Given -> <5>{Given}
  in terms of Letters ->

FromRest
  (if|when|after|being) [Thing|it is|Thing is|being] [it] [is] (released|let go|starting|starts|started) from rest ->
      @from_rest

Letters
  Par [,] [and] Letters ->
  Par and Par ->
  Par , Par ->

Arg
  Coord -> {Coord}
  time -> t
  (angle|distance|position):x [Coord] -> @coordinate
  Par -> {Par}
  (state|positions and speeds|position and speed) -> state
  (speed|velocity) of Coord -> speed of {Coord}

Given
  (with|if|when|where|for|given|taking|at) Par (=|is) Value [Givens] -> with {Par} = {Value}{Givens}

Givens
  [,|and] Par (=|is) Value [Givens] -> , {Par} = {Value}{Givens}

Moment
  At (start|beginning|first|outset|starting|start-up|release|moment of release|instant of release|start of motion|
      beginning of motion|instant it is released|moment it is released|very start|very beginning) -> at start
  (initially|at first|just after release|right after release|immediately after release|shortly after release|on release|
      upon release|at release|when released|just after it is released) -> at start
  [JustAfter|when|as soon as|once|at instant|at moment|instant|moment] (Subj|system|mechanism|assembly|everything) (is|
      are|has been|was) (released|let go|set free) [from rest] -> at start
  (at|in) its (initial|starting) position -> at start
  (at|in|for) (instant|position|moment|configuration) (shown|given|considered) -> @now
  (at|in|for) (given|shown) (instant|position|moment|configuration) -> @now
  afterwards -> @after_blow
  (on|upon) Event -> where {Event}
  When Event -> where {Event}
  When Begin -> when {Begin} begins
  When BeginClause -> when {BeginClause} begins
  JustBefore Event -> where {Event}
  JustBefore (Begin|Blow):x [Begins] -> just before {x}
  JustBefore BeginClause -> just before {BeginClause}
  JustAfter (Begin|Blow):x [Begins] -> right after {x}
  after (Begin|Blow):x [Begins] -> right after {x}
  JustAfter BeginClause -> right after {BeginClause}
  JustAfter (Element|string|cord|thread|support|prop|it|other|other one|one|other string|one string) Cut -> @cut_at_start
  (JustAfter|after) (cutting|release|burning) [Element] -> @cut_at_start
  after BeginClause -> right after {BeginClause}
  (JustAfter|after) Passing -> where {Passing}
  before (Blow|BlowNoun):x -> just before {x}
  JustBefore BlowNoun -> just before impact
  (JustAfter|after) BlowNoun -> right after impact
  (just before|right before|immediately before|just after|right after|immediately after|before|after):side Subj Hit
      HitWhat -> @blow
  When Subj (first|) Hit HitWhat -> @blow
  (JustAfter|after) BlowClause -> @after_blow
  (JustAfter|after) (striking|hitting|meeting) (Body|Point|Unknown) -> @after_blow
  JustBefore BlowClause -> @before_blow
  (JustBefore|JustAfter|after|When):side Subj Begun [Unknown|Ground|Body] -> @begun
  (When|JustBefore) Body (Hit|Reach) Floor -> @flat
  (when|as|where|while|after) Subj [Aux] (passes|passing|swings|moves|goes|is passing|reaches) [through] [its]
      (equilibrium| equilibrium position|position of equilibrium) -> where potential energy is smallest
  At extreme [position|positions|point] -> where it comes to rest
  At Place -> where {Place}
  on (hitting|striking) HitWhat -> @blow
  (in|at|for) [stable|static] (equilibrium|rest|equilibrium position|equilibrium configuration|rest position) -> in
      equilibrium
  (at|through) [its] (equilibrium position|position of equilibrium|rest position) -> where potential energy is smallest
  (at|in) [its|position of] unstable (equilibrium|equilibrium position) -> in unstable equilibrium
  At [its] (lowest|bottom):x (point|position|place) [of [its] (path|swing|motion|arc|track|loop|circle|hill|dip)] -> at
      its lowest point
  At [its] (highest|top|uppermost):x (point|position|place) [of [its] (path|swing|motion|arc|track|loop|circle|hill)] ->
      at its highest point
  At bottom [of [its] (path|swing|motion|arc|track|loop|circle|bowl|dip|trough)] -> at bottom
  At top [of [its] (path|swing|motion|arc|track|loop|circle|hill)] -> at top
  When Subj [Aux] (is in|is at|in|reach|reaches|pass|passes|passes through|is passing through|reaches its|passes its|goes
      through|is passing) [its|through] (lowest|bottom) [point|position|place] [of [its] (path|swing|motion|arc|track|
      loop| circle)] -> where {Subj} is at its lowest point
  When Subj [Aux] (is in|is at|in|reach|reaches|pass|passes|passes through|is passing through|goes through|is passing)
      [its| through] (highest|uppermost|top) [point|position|place] [of [its] (path|swing|motion|arc|track|loop|circle)]
      -> where {Subj} is at its highest point
  At [its] turning point [of Coord] -> at turning point
  At end of (phase Phase|Phase) -> at end of phase {Phase}
  after Elapsed -> {Elapsed}

Elapsed
  [a] [time] [of] Time -> where t = {Time}
  Value (turns|revolutions|rotations|turn|revolution) [of Body] -> @turned
  (one|a|one full|a full|one complete) (turn|revolution|rotation) [of Body] -> @turned
  a fall of Value -> where it has fallen {Value}
  (falling|descending|dropping) [through] [a (distance|height) [of]] Value -> where it has fallen {Value}

At
  (at|in|from|for|with it at) [moment of|instant of|point of] ->
  at [the] ->

When
  (when|where|once|as|as soon as|at instant|at instant when|at instant that|at moment|at moment when|at moment that|at
      point where|at time|at time when|just as|just when|the moment|the instant|by time|at which|at position where|at
      place where|for position where|at instant at which) [first] ->

JustBefore
  (just|right|immediately|shortly|directly|an instant|the instant) (before|prior to) ->

JustAfter
  (just|right|immediately|shortly|directly|an instant) (after|following) ->
  following ->
  as soon as ->

Begins
  (begins|starts|has begun|sets in|begin) ->

BeginClause
  (Element|It|Contact):who Cut -> @cut
  Element [Aux] (becomes|goes|gets|is|pulled) (taut|tight|stretched) -> @taut

Aux
  (becomes|gets|is being|has|have|had|has just|have just|just|will|first|has first|to|can|would|could|is just|does|do|did|
      may|must| momentarily|to just|will just|just has|is|are|be|being|in|on|by|will have|first has) ->

BlowNoun
  (impact|collision|blow|bounce|it is struck|striking|hit|catch|jump|jerk|capture|embedding|landing|rebound|strike) ->

BlowClause
  (Subj|[its|one|one of its|free] (end|corner|edge|foot|tip|side)) [Aux] (caught|hooked| embedded|captured|struck|hit|
      kicked|stuck|lodged|latched|hits|jumped|landed|jumps|lands|collided|bounced) [it|on| onto|in|by|to|up|off|off it|
      onto it|on it] [Body|Point|Unknown] -> impact
  (Subj|Stranger) [Aux] (becomes|is|goes|gets|become|gone|pulled) (taut|tight) -> impact
  (Subj|Stranger) [Aux] (passed|passes|gone|goes) (through|right through) (Body|Point) -> impact
  (Unknown|Body) (catches|grabs|seizes|engages|strikes|hits|captures|hooks) [(its|one|free)] (end|Body| Point|it|corner|
      edge) -> impact
  (they|Body and Body|bodies|two) (collide|meet|stick together|join|become joined|strike each other|hit each other) ->
      impact
  (embedding|catching|landing|hooking|capture) -> impact

Target
  (hand|hook|peg|hammer|cue|finger|nail|stop|ridge|obstacle|step|kerb|curb|target|club|racket|bat|ledge|wall|other) ->

Unknown
  Target ->
  Stranger -> !1

Direction
  (vertical|wall) -> vertical
  (horizontal|floor|ground) -> horizontal

HitWhat
  (Body|Ground|Point):x -> {x}
  Stranger:x -> {x} !1

Event
  Passing -> {Passing}
  Happening -> {Happening}
  Gripping -> {Gripping}

Passing
  [Subj] Fall [down|by|through] [a|its] [(distance|height|depth|way)] [of] Length -> {Subj} has fallen {Length}
  [to] (lift|raise|pull up|hoist|haul up) Body (to|through|by|up) [a] (height|distance) [of] Length -> {Body} has risen
      {Length}
  [to] (lift|raise|hoist) Body (by|through) Length -> {Body} has risen {Length}
  [to] (lower) Body (by|through|a distance) Length -> {Body} has fallen {Length}
  [Subj] Reach height [of] Length -> {Subj} has risen {Length}
  [Subj] Rise [up|by|through] [a] [(distance|height)] [of] Length -> {Subj} has risen {Length}
  [Subj] Go [down|up|by|through|along] [a|its] [(distance|way|length)] [of] Length [Along] -> {Subj} has moved {Length}
  [Subj] Turn [through|by|around] [angle] [of] Turned -> {Subj} has turned {Turned}
  [Subj] [Aux] (made|make|makes|making|complete|completed|completes|Turn) Value (turns|revolutions|rotations|full turns)
      -> {Subj} has turned 2*pi*({Value})
  [Subj] [Aux] (made|make|makes|making|complete|completed|completes) (one|a|one full|a full|a complete|one complete)
      (turn| revolution|rotation) -> {Subj} has turned 2*pi
  Coord [Aux] (=|is|reaches|equals|becomes|reach|has reached|has value|reaches value|is equal to|be|to be|has become)
      Value -> {Coord} = {Value}
  [angle|position] Coord = Value -> {Coord} = {Value}
  [Subj] Reach Place -> {Place}
  Subj (at|is at) Place -> {Place}
  State (to be|to become|to reach|to fall to|to drop to|to decrease to|to rise to|to increase to|=|is|reaches|equals|
      becomes|has fallen to|has dropped to|falls to|drops to|has risen to|is reduced to|is equal to| has decreased to|has
      increased to) Value -> {State} = {Value}
  State:a (=|is|reaches|equals|becomes|is equal to) State:b -> {a} = {b}
  (speed|velocity|Turns):n [of (Coord|Holder)] Sinks [to] half [of] [its] [initial|original|first] [value] -> @halved
  Subj (has|have|with|reaches|attains|acquires|gets|have reached|has reached|is moving at|is moving with|moves with|moves
      at| to reach|to attain|reaching|to have|moves with a|travels at) [a|its] [speed|velocity] [of] SpeedValue -> @speed
  Subj (has|have|with|reaches|attains|acquires|gets|have reached|has reached|to reach|to attain|reaching|to have|rotates
      at| turns at|turns with) [its] (angular velocity|angular speed|speed) [of] TurnValue -> angular velocity of {Subj} =
      {TurnValue}

Sinks
  (has fallen|falls|to fall|fall|drops|to drop|drop|has dropped|is reduced|to be reduced|decreases|to decrease|sinks|
      becomes|is) ->

Happening
  State (is|becomes|reaches its) Top -> {State} is {Top}
  [Subj] Stop [momentarily|for first time|instantaneously|spinning|rotating|turning|moving] -> @rests
  [Subj] Return [to (its|start|starting|initial|where|original)] [start|point|position|starting point|starting position|
      place| it started] -> {Subj} comes back
  [Subj] [Aux] Leave [Ground:g|Body:g|Point:g|other|other one|it|Stranger] -> @leaves
  String [Aux] (stops being taut|is no longer taut|loses tension|goes slack|becomes slack|go slack|become slack|is slack|
      slackens) -> {String} goes slack
  Contact [Aux] (Leave|lose contact|loses contact) [Ground] -> {Contact} vanishes !1
  Held (vanishes|is lost|vanish|is zero|becomes zero|drops to zero|falls to zero) -> @vanishes
  (contact|it) [Aux] (is lost|ceases|loses contact) -> contact is lost
  Subj [Aux] (reaches|reach|is at|be at|reached|gets to) (maximum height|greatest height|highest point|top of [its] path|
      highest position) -> @highest
  [Subj] reach (maximum height|greatest height|highest point|highest position) -> @highest
  Subj (returns|return|falls back|comes back|is back) to (ground|floor|where it was thrown|hand) -> {Subj} comes back
  [Subj] (begins|starts|begin|start|to begin|to start|just begins|first begins|beginning|starting) (to slip|to slide|
      slipping| sliding|to skid) -> {Subj} slips
  [Subj] (slips|slip) -> {Subj} slips
  [Subj] [Aux] Tip -> {Subj} tips
  Subj (is|becomes|are|gets|has become|be|being|to be|comes to be|passes|passes through|passing through|swings through|
      reaches) [its|a] ( vertical|horizontal):x [position] -> {Subj} is {x}
  Subj (makes|makes an angle of|forms|makes an angle|is inclined at|is at) [an angle of|angle of] Value [degrees|deg]:d
      (with|to|from) Direction:x -> {Subj} makes {Value} {d} with {x}
  [Subj] Reach [its] Direction [position] -> {Subj} is {Direction}
  Subj (is|be) (lowest|at its lowest|highest|at its highest):x -> @extreme
  [Subj] (is in|in|to) [a] (vertical|horizontal):x position -> {Subj} is {x}
  Body:a (catches|overtakes|reaches|catches up with|meet|meets|catch|overtake|passes) Body:b -> {a} meets {b}
  Body:a and Body:b (meet|pass|are level|are side by side|collide|are at same height|are at same level) -> {a} meets {b}
  Body:a and Body:b (have|turn with|rotate with|turn at|rotate at) (same|equal|a common) angular (velocity|speed|
      velocities| speeds) -> {a} and {b} have same angular velocity
  Spring [Aux] (reaches|is at|has|regains|returns to|attains) [its] (natural|unstretched|free|original|undeformed|relaxed)
      length -> {Spring} is unstretched
  Spring [Aux] (is|becomes|gets) (relaxed|unstretched|unstressed|undeformed|slack|uncompressed) -> {Spring} is unstretched
  Spring (is|has) (most compressed|maximum compression|its maximum compression|fully compressed|compressed most) ->
      compression of {Spring} is largest
  Spring (is|has) (most stretched|maximum extension|its maximum extension|stretched most|fully stretched) -> elongation of
      {Spring} is largest
  Spring (is|has been) (compressed|stretched|extended):c by Length -> @stretched
  Subj (is|are|be) (moving|going|sliding|turning|rolling) (fastest|most quickly) -> speed of {Subj} is largest

Gripping
  [Subj] (stops|stop|ceases|cease|no longer|has stopped) (slipping|sliding|slips|slides|skidding|to slip|to slide|skids)
      [(on| over|along) (each other|one another|Body|Ground)] -> {Subj} stops slipping
  (slipping|sliding|slip|skidding) (stops|ceases|ends|has ceased|has stopped) -> it stops slipping
  [Subj] (begins|starts|begin|start|has begun|has started|beginning|starting|to begin|to start) (rolling|to roll|pure
      rolling) [without slipping|purely] -> {Subj} stops slipping
  [Subj] (rolls|roll|rolling|is rolling|to roll) [without slipping|without sliding|purely] -> {Subj} stops slipping
  [Subj] (moves|move|moving|travels|turns|rotates) with (Ground|Body|belt) -> {Subj} stops slipping
  (rolling|pure rolling|rolling without slipping) (begins|starts|sets in|has begun|occurs) -> it stops slipping

Turned
  Angle -> {Angle}
  Value (degrees|deg|degree) -> ({Value})*pi/180

Place
  Coord [=|of] Value -> {Coord} = {Value}

Spans
  Span [,] [Spans] -> {Span} {Spans}
  Given -> <5>{Given}

Span
  Until Event [for first time] -> <2>until {Event}
  Until (Begin|Blow|Phase):x [Begins] -> <2>until {x}
  Until BeginClause -> <2>until {BeginClause}
  from (start|rest|release|beginning) (to|until|till|up to) [where|when|moment when|instant when|moment|instant] Event ->
      <2>until {Event}
  from (beginning|start) of (phase Phase|Phase) (to|until|till|up to) [where|when] Event -> <1>in phase {Phase} <2>until
      {Event}
  from when Phase Begins (to|until|till|up to) [where|when] Event -> <1>in phase {Phase} <2>until {Event}
  between (start|release) and [moment when|instant when|where|when] Event -> <2>until {Event}
  (in|during) Gerund -> <2>until {Gerund}
  (during|in|over|throughout) (phase Phase|Phase) -> <1>in phase {Phase}
  (during|in|by|due to|at|on) [each] BlowNoun -> @in_blow
  (when|as|because|while) BlowClause -> @in_blow
  (while|during|in) (slipping|sliding|skidding|slip) -> <2>until it stops slipping
  while it (slips|slides|skids) -> <2>until it stops slipping
  (at|on) Target -> @in_blow
  Until BlowClause -> @until_blow
  while Passing -> <2>until {Passing}
  (in|during|over|for) (one|a|each) [full|complete|whole] (turn|revolution|rotation) [of Body:b] -> @one_turn
  Reached ->
  (as [a] function of|in terms of) Arg -> <3>as a function of {Arg}
  after (Begin|Blow|BlowNoun):x -> <2>after {x}
  At start -> <2>at start
  over Par -> <2>over {Par}
  over Par between Value:a and Value:b -> <2>over {Par} between {a} and {b}
  (from|between) Coord:c [=] Value:a (to|and) [Coord] [=] Value:b -> <2>from {c} = {a} to {c} = {b}

Until
  (until|till|up to|before|up to time|up to moment|up to instant|by time|by time that|when|once|to|in|for|at instant|upto|
      until moment when|until it|by moment| for it|up to where|by instant) [where|when|moment|instant] ->

Gerund
  Event -> {Event}

After
  [JustAfter|after|on] BlowNoun -> after impact
  after (Blow|Begin):x -> after {x}

Along
  (up|down|along|on|over|across|upwards|downwards|horizontally|vertically) [on| along] [Ground|incline|slope|plane|hill|
      ramp|table|floor] ->

FarVerb
  (go|move|slide|roll|travel|climb|rise|fall|drop|get|advance|gone|moved|slid|travelled|driven|pushed|recoil|descend|sink|
      drop|skid) ->

Moving
  (moving|going|sliding|rolling|travelling|traveling|falling|rising|move|go|slide|roll|travel|swing|fall|rise|be moving|
      then moving|be going) ->

Turning
  (turning|rotating|spinning|turn|rotate|spin|swinging) ->
"""

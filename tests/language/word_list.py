"""The word list of the course's style: words to replace, and what to write instead."""

import re
from dataclasses import dataclass


@dataclass(frozen=True)
class Rule:
    """Words to replace.

    `instead`: what to write. `words`: a regular expression that matches whole words, in any case.
    """

    instead: str
    words: str
    questions: bool = True
    """Whether the rule also applies to questions."""

    def found(self, text: str) -> list[str]:
        """Return each part of a text that breaks the rule."""
        return [hit[0] for hit in re.finditer(rf"(?<![\w-])(?:{self.words})(?![\w])", text, re.IGNORECASE)]


RULES = {
    "mend": Rule("fix", r"mend(?:s|ed|ing)?"),
    "twins": Rule("duplicate node names", r"twins?"),
    "full name": Rule("fully qualified name", r"full names?"),
    "crank": Rule("iteration", r"crank(?:s|ed|ing)?"),
    "listener's depth": Rule("the subscription's queue depth", r"depth of the listener|listener's depth"),
    "doors": Rule("UDP ports, or what happens there", r"doors?|front door|through the door"),
    "notebook's bus": Rule("ROS domain", r"bus of (?:this|the) notebook|notebook's bus"),
    "pictures of callbacks": Rule(
        "callback, executor, wait set, ready", r"postman|postmen|bells?|pumps?|pumped|pumping"
    ),
    "strangers": Rule("untrusted program, untrusted code", r"strangers?(?:'s?)?"),
    "cage": Rule("sandbox, isolation tier, confinement", r"cages?|fences?|fenced|shut in|shuts? programs in"),
    "pack bytes": Rule("serialize, marshal", r"pack(?:s|ed)? bytes"),
    "bench": Rule("the judge", r"the bench|bench's|by the bench"),
    "floor": Rule("layer", r"(?:upper|lower|next|top|bottom) floors?|floors? (?:above|below)"),
    "falls silent": Rule("stops publishing, goes silent", r"f[ae]ll(?:s|en)? silent|never heard"),
    "stock ROS": Rule("this build, the Ubuntu packages", r"stock ROS"),
    "last cry": Rule("exception, traceback, exit code", r"last cry|last cries"),
    "that is none": Rule("say what it is: 'Invalid names'", r"(?:that|which|who) (?:is|are) none"),
    "shall": Rule("must, will, or an imperative", r"shall|shan't"),
    "whoever": Rule("name who does it", r"whoever|whomever|whosoever"),
    "somebody": Rule("name who does it; 'someone' if nobody can be named", r"somebody|somebody's"),
    "without a word": Rule("silently; or say that nothing is printed", r"without a (?:loud )?word"),
    "told": Rule(
        "log, print, report, say", r"(?:is|are|was|were|be|been) told (?!to\b|apart\b)(?:of|once|by|again)"
    ),
    "fell due": Rule("is due, expires", r"f[ae]ll(?:s|en)? due"),
    "grain of salt": Rule("one caveat", r"grains? of salt"),
    "voice": Rule("publishing", r"tak(?:es?|en|ing) its voice"),
    "deed": Rule("call, action", r"deeds?"),
    "from birth": Rule("from the start, comes with", r"from birth"),
    "an own": Rule("its own, your own, a separate", r"an own"),
    "has to do with": Rule("write out what", r"is no business of"),
    "for ever": Rule("forever", r"for ever"),
    "one after the other": Rule("one after another", r"the one who called|he who"),
    "British -our": Rule(
        "color, behavior, neighbor, favor",
        r"(?:colou?r(?<=our)|behaviour|neighbour|favour|honour|labour|rumour|armour|harbour)\w*",
    ),
    "British -ise": Rule(
        "practice, organize, recognize",
        r"(?:practis|organis|recognis|initialis|serialis|normalis|realis|summaris|optimis|visualis|synchronis|emphasis(?=e))(?:es?|ed|ing|ation)\w*",
    ),
    "British -re": Rule("meter, center, liter", r"(?:kilo|centi|milli)?(?:metre|centre|litre|fibre)s?"),
    "British doubling": Rule(
        "canceled, labeled, modeled, traveled",
        r"(?:cancell|labell|modell|travell|signall|channell)(?:ed|ing|er|ers)",
    ),
    "British words": Rule(
        "gray, license, program, while, toward",
        r"grey|licence|programmes?|whilst|amongst|catalogue|dialogue|cheque|artefacts?|towards|judgement|judgements|"
        r"afterwards|upwards|learnt|spelt|burnt",
    ),
    "picture": Rule("image (camera); figure (drawing)", r"(?<![.(])pictures?(?![.(]| =|: \[)"),
    "how late": Rule("latency, delay, lag", r"how late"),
    "memory of a filter": Rule(
        "state", r"memory of (?:the|a|your) (?:filter|node)s?|(?:filter|node)'s memory"
    ),
    "takes for": Rule(
        "assumes, interprets as",
        r"(?:takes?|took|taking|taken) (?:it|them|this|that|what|each) for (?:an?|the|one|another)|"
        r"(?:takes?|taken) for (?:an?|the|one|another)(?! second| minute| moment| while)",
    ),
    "in the place of": Rule("instead of", r"in the place of"),
    "at once": Rule("right away; at the same time", r"at once"),
    "beside": Rule("next to; along with; except", r"besides?"),
    "anew": Rule("again, reset, re-create; back and forth", r"anew|to and fro"),
    "dated adverbs": Rule("say when", r"meanwhile|now and then|all the same|as ever"),
    "quick": Rule("fast", r"quick|quicker|quickest"),
    "look": Rule("poll", r"(?:one|each|every|next|first|last) look(?! around)"),
    "grader": Rule("the judge; grading (by instructors)", r"(?<!Classroom's )(?<!autograder or )graders?"),
    "holds": Rule(
        "passes, fails, not yet", r"criteri(?:on|a)(?: that)? (?:holds?|held)|(?:holds?|held) criteri(?:on|a)"
    ),
    "hears": Rule("receives", r"hears?|heard|hearing"),
    "what-clause": Rule(
        "the thing's name",
        r"(?<!no matter )what (?:is|was|are|were|has|have|comes|came|they)(?! judged| wrong| missing)",
        questions=False,
    ),
    "of a library": Rule("a compound: NumPy array", r"of (?:NumPy|OpenCV|rclpy|DDS|ROS)(?!'s| 2)"),
    "of its own": Rule("its own, a separate", r"of (?:its|their|your|our|his|her|my) own"),
    "of-chain": Rule("a compound or a possessive", r"of \w+ \w+ of (?:\w+ ){1,3}of"),
    ", and nothing": Rule(
        "because, so, or but",
        r"(?<=, )and (?:nothing(?! else)|no (?!others?\b|longer\b|more\b))",
    ),
    "vague pronoun": Rule(
        "the noun",
        r"(?<!stay )(?<!stays )(?<!always )(?<!means )(?<!is )(?<!are )(?<!do )(?<!nearly )the same(?=[.,;:)]|$)|"
        r"(?:that|those) of|(?<!than )this one|the other one",
    ),
    "personification": Rule(
        "publishes, receives, returns, raises, stores, waits",
        r"(?:programs?|nodes?|cameras?|filters?|timers?|queues?|rclpy|DDS|publishers?|subscribers?|subscriptions?|executors?|judge|listeners?)"
        r" (?:says?|tells?|knows?|wants?|believes?|means?|learns?|looks?)",
    ),
    "nobody": Rule("what the function does or returns", r"nobody|None where|where none"),
    "so long": Rule("how long, how many, how often", r"so (?:long|often)(?! as)"),
    "as it was": Rule(
        "unchanged; say what was before",
        r"as (?:it|they) (?:was|were)(?! \w+(?:ed|en|t)\b)|"
        r"c[oa]mes? at(?! least| most| any moment| intervals| one moment| no whole)",
    ),
}

package wbv.body;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.Collections;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import wbv.body.law.Law;
import wbv.body.number.Check;
import wbv.body.number.Key;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Quantity;

/**
 * A lumped model as its user writes it: a base, bodies, and links between them, on one axis.
 *
 * <p>A body is one motion: along the axis, or, where a model has several, along another or an angle. What moves along two and turns is
 * three of them, which share a mass, hang together by the lever arms of links and sensors, and are carried by the base's axes as
 * {@link Body#carried} says. {@link ModelFile} makes them from bodies in a plane and from matrices.
 *
 * <p>It is moved either by its base's measured motion, or, the base at rest, by measured forces on bodies. Where all bodies are
 * fixed, the links are driven: nothing swings, and what the links carry follows from the base's motion alone.
 *
 * @param source where the values come from, and how sure they are
 * @param inputs measured forces; none where the base moves
 * @param declared what its user says it is; where nobody does, {@link #subject} goes by what it holds
 * @param sensors what reads more than one body's own motion
 */
public record Model(String name, Optional<String> source, char axis, Base base, List<Body> bodies, List<Link> links, List<Input> inputs,
        Optional<Subject> declared, List<Sensor> sensors) {

    /**
     * In a plane.
     *
     * @param x forward [m]
     * @param z upward [m]
     */
    public record Point(double x, double z) {
        public Point {
            Check.finite("x", "m", x);
            Check.finite("z", "m", z);
        }
    }

    /** What a model is of. */
    public enum Subject {
        /** Someone who sits: shaken below about 20 Hz, breathing, with reflexes and forces of his own. */
        PERSON,
        /** A test rig, at rates and with forces of its own, which does nothing by itself. */
        RIG;

        /** As {@code model.json} has it. */
        public String word() {
            return name().toLowerCase(Locale.ROOT);
        }
    }

    /**
     * What moves everything.
     *
     * @param sensor  its measured acceleration, velocity or position; none for a base at rest
     * @param mass    what of the sitter moves with it rigidly [kg], &gt;= 0: part of what it carries, of no motion
     * @param further what measures its motion along further axes, angles among them
     * @param at      where its sensor is, in a plane; empty where motions are small
     * @param filter  which that sensor passed, and all others did too; empty where nothing is said of it
     */
    public record Base(String name, Optional<Channel> sensor, double mass, List<Channel> further, Optional<Point> at,
            Optional<SensorFilter> filter) {
        /**
         * A base of whose sensor's filter nothing is said.
         *
         * @param mass [kg]
         */
        public Base(String name, Optional<Channel> sensor, double mass, List<Channel> further, Optional<Point> at) {
            this(name, sensor, mass, further, at, Optional.empty());
        }

        /**
         * A base that moves along one axis.
         *
         * @param mass [kg]
         */
        public Base(String name, Optional<Channel> sensor, double mass) {
            this(name, sensor, mass, List.of(), Optional.empty());
        }

        /** A base that nothing of the sitter is one with. */
        public Base(String name, Optional<Channel> sensor) {
            this(name, sensor, 0);
        }

        public Base {
            Check.notNegative("mass of " + name, "kg", mass);
            further = List.copyOf(further);
            if (sensor.isEmpty() && !further.isEmpty()) {
                throw new IllegalArgumentException("the base '" + name + "' has further sensors but no first one");
            }
            if (sensor.isEmpty() && filter.isPresent()) {
                throw new IllegalArgumentException("the base '" + name + "' has an anti-alias filter but no sensor");
            }
            if (sensor.map(further::contains).orElse(false) || Set.copyOf(further).size() < further.size()) {
                throw new IllegalArgumentException("a sensor of the base '" + name + "' is named twice: " + further);
            }
        }

        /** What measures its motion, by axis; none for a base at rest. */
        public List<Channel> sensors() {
            List<Channel> all = new ArrayList<>();
            sensor.ifPresent(all::add);
            all.addAll(further);
            return all;
        }
    }

    /**
     * A sensor that reads a combination of motions: off a body's centre, across it, or of several bodies.
     *
     * @param channel what it gives
     * @param reads   what it reads of each body's motion, by name: plain factors, or lever arms [m] of what turns
     * @param at      where it sits on a body in a plane
     */
    public record Sensor(Channel channel, Map<String, Double> reads, List<SensorFault> faults, Optional<Point> at) {
        public Sensor {
            checkArms("the sensor " + channel, reads);
            if (reads.values().stream().allMatch(factor -> factor == 0)) {
                throw new IllegalArgumentException("the sensor " + channel + " reads no body's motion");
            }
            reads = Collections.unmodifiableMap(new LinkedHashMap<>(reads));
            faults = List.copyOf(faults);
        }

        /** The body of which it reads most, by factor; the first of several. */
        public String body() {
            return reads.keySet().stream().reduce((a, b) -> Math.abs(reads.get(b)) > Math.abs(reads.get(a)) ? b : a).orElseThrow();
        }
    }

    private static void checkArms(String whose, Map<String, Double> arms) {
        arms.forEach((body, arm) -> Check.finite(whose + ": arm of " + body, "m", arm));
    }

    /**
     * A measured force.
     *
     * @param body on which it acts
     * @param sensor what measures it [N]
     * @param offset what that reads at no force [N]
     */
    public record Input(String body, Channel sensor, double offset) {
        /** A measured force whose sensor reads 0 N at no force. */
        public Input(String body, Channel sensor) {
            this(body, sensor, 0);
        }

        public Input {
            if (sensor.quantity() != Quantity.FORCE) {
                throw new IllegalArgumentException("an input on '" + body + "' must be a measured force: " + sensor);
            }
        }
    }

    /**
     * A rigid body.
     *
     * @param mass [kg], &gt; 0, or the moment of inertia [kg m²] of what turns
     * @param sensor what measures it
     * @param faults of that sensor
     *
     * @param hidden a mass on a spring that nobody sees
     * @param forces on the body that nobody measured
     * @param fixed whether it is held at rest; its mass then plays no part
     * @param carried what it moves by with a unit of each of the base's axes, by the base's sensor; empty: along the first, as it is
     * @param massOf the body whose mass it shares, since both are motions of one; empty where it has its own
     * @param turns whether it is an angle [rad], and what acts on it a moment [N m]
     * @param at    where the centre of mass is, in a plane, of which this is a motion: its name ends in {@code .x}, {@code .z} or
     *              {@code .pitch}
     * @param within by what part the mass may be another, with 95 % [1], at most 1; empty where nobody says how well it is known
     */
    public record Body(String name, double mass, Optional<Channel> sensor, List<SensorFault> faults, Optional<HiddenMode> hidden,
            List<Drive> forces, boolean fixed, Map<Channel, Double> carried, Optional<String> massOf, boolean turns, Optional<Point> at,
            OptionalDouble within) {
        /** No scale weighs better [1]. */
        private static final double LEAST_WITHIN = 1e-6;

        /**
         * A body of which nobody says how well its mass is known.
         *
         * @param mass [kg], &gt; 0, or the moment of inertia [kg m²] of what turns
         */
        public Body(String name, double mass, Optional<Channel> sensor, List<SensorFault> faults, Optional<HiddenMode> hidden,
                List<Drive> forces, boolean fixed, Map<Channel, Double> carried, Optional<String> massOf, boolean turns,
                Optional<Point> at) {
            this(name, mass, sensor, faults, hidden, forces, fixed, carried, massOf, turns, at, OptionalDouble.empty());
        }

        /**
         * A body along the base's first axis, with a mass of its own.
         *
         * @param mass [kg], &gt; 0
         */
        public Body(String name, double mass, Optional<Channel> sensor, List<SensorFault> faults, Optional<HiddenMode> hidden,
                List<Drive> forces, boolean fixed) {
            this(name, mass, sensor, faults, hidden, forces, fixed, Map.of(), Optional.empty(), false, Optional.empty());
        }

        /**
         * A body that is free to move along the base's first axis.
         *
         * @param mass [kg], &gt; 0
         */
        public Body(String name, double mass, Optional<Channel> sensor, List<SensorFault> faults, Optional<HiddenMode> hidden,
                List<Drive> forces) {
            this(name, mass, sensor, faults, hidden, forces, false);
        }

        /** A body held at rest. */
        public static Body fixed(String name) {
            return new Body(name, 1, Optional.empty(), List.of(), Optional.empty(), List.of(), true);
        }

        public Body {
            Check.positive("mass of " + name, "kg", mass);
            if (fixed && (sensor.isPresent() || hidden.isPresent() || !forces.isEmpty())) {
                throw new IllegalArgumentException("'" + name + "' is fixed: it carries no sensor, no hidden mass and no force");
            }
            faults = List.copyOf(faults);
            forces = List.copyOf(forces);
            carried = Collections.unmodifiableMap(new LinkedHashMap<>(carried));
            carried.forEach((axis, part) -> Check.finite(name + " carried by " + axis, "1", part));
            within.ifPresent(part -> Check.within("part within which the mass of " + name + " is known", "1", part, LEAST_WITHIN, 1));
        }

        private Body unseen() {
            return new Body(name, mass, Optional.empty(), List.of(), hidden, forces, fixed, carried, massOf, turns, at, within);
        }

        /**
         * The same body, completed.
         *
         * @param kilograms its mass [kg], or moment of inertia [kg m²]
         */
        public Body completed(double kilograms, List<SensorFault> found, Optional<HiddenMode> rider, List<Drive> acting) {
            return new Body(name, kilograms, sensor, found, rider, acting, fixed, carried, massOf, turns, at, within);
        }
    }

    /**
     * A mass that rides on a body.
     *
     * @param mass [kg]
     * @param frequency of its own [Hz]
     * @param dampingRatio of its own [1], all &gt; 0
     * @param cubic by how much its spring stiffens [1/m²], at least 0: its force is that of a linear one times 1 + cubic r²
     */
    public record HiddenMode(@Key("mass_kg") double mass, @Key("frequency_hz") double frequency,
            @Key("damping_ratio") double dampingRatio, @Key("cubic_per_m2") double cubic) {

        /**
         * On a linear spring.
         *
         * @param mass [kg]
         * @param frequency [Hz]
         * @param dampingRatio [1]
         */
        public HiddenMode(double mass, double frequency, double dampingRatio) {
            this(mass, frequency, dampingRatio, 0);
        }

        public HiddenMode {
            Check.notNegative("stiffening of a hidden mode's spring", "1/m²", cubic);
            Check.positive("hidden mass", "kg", mass);
            Check.positive("hidden mode's frequency", "Hz", frequency);
            Check.positive("hidden mode's damping ratio", "1", dampingRatio);
        }

        /** Stiffness of its spring [N/m]. */
        public double stiffness() {
            double omega = 2 * Math.PI * frequency;
            return mass * omega * omega;
        }

        /** What its spring has beside its stiffness; empty where it is linear. */
        public Optional<Law> stiffening() {
            return cubic > 0 ? Optional.of(Law.stiffening(cubic * stiffness())) : Optional.empty();
        }

        /** Damping of its dashpot [N s/m]. */
        public double damping() {
            return 2 * dampingRatio * 2 * Math.PI * frequency * mass;
        }
    }

    /**
     * A spring and a dashpot between two bodies, and what else acts there.
     *
     * @param stiffness [N/m], &gt;= 0
     * @param damping [N s/m], &gt;= 0
     * @param sensor what measures the force in it
     * @param faults of that sensor
     * @param arms what other bodies' motion stretches it by, beside that of its two ends, by name: lever arms [m], or plain factors
     * @param at   where it acts, in a plane
     */
    public record Link(String from, String to, double stiffness, double damping, Optional<Channel> sensor, List<Law> laws,
            List<Drive> drives, List<SensorFault> faults, Map<String, Double> arms, Optional<Point> at) {
        /**
         * A link that its two ends alone stretch.
         *
         * @param stiffness [N/m]
         * @param damping [N s/m]
         */
        public Link(String from, String to, double stiffness, double damping, Optional<Channel> sensor, List<Law> laws,
                List<Drive> drives, List<SensorFault> faults) {
            this(from, to, stiffness, damping, sensor, laws, drives, faults, Map.of(), Optional.empty());
        }

        /**
         * A link that its two ends alone stretch, its sensor without faults.
         *
         * @param stiffness [N/m]
         * @param damping [N s/m]
         */
        public Link(String from, String to, double stiffness, double damping, Optional<Channel> sensor, List<Law> laws,
                List<Drive> drives) {
            this(from, to, stiffness, damping, sensor, laws, drives, List.of());
        }

        public Link {
            Check.notNegative("stiffness of " + from + "-" + to, "N/m", stiffness);
            Check.notNegative("damping of " + from + "-" + to, "N s/m", damping);
            laws = List.copyOf(laws);
            drives = List.copyOf(drives);
            faults = List.copyOf(faults);
            checkArms("link " + from + "-" + to, arms);
            arms = Collections.unmodifiableMap(new LinkedHashMap<>(arms));
        }

        private Link unseen() {
            return new Link(from, to, stiffness, damping, Optional.empty(), laws, drives, List.of(), arms, at);
        }

        /**
         * The same link, completed.
         *
         * @param k stiffness [N/m]
         * @param c damping [N s/m]
         */
        public Link completed(double k, double c, List<Law> found, List<Drive> acting, List<SensorFault> amiss) {
            return new Link(from, to, k, c, sensor, found, acting, amiss, arms, at);
        }

        /** {@code from-to}. */
        public String name() {
            return from + "-" + to;
        }
    }

    public Model {
        bodies = List.copyOf(bodies);
        links = List.copyOf(links);
        inputs = List.copyOf(inputs);
        sensors = List.copyOf(sensors);
        if (bodies.isEmpty()) {
            throw new IllegalArgumentException("a model needs at least one body");
        }
        Set<String> names = new HashSet<>(Set.of(base.name()));
        for (Body body : bodies) {
            if (!names.add(body.name())) {
                throw new IllegalArgumentException("two bodies are named '" + body.name() + "'");
            }
        }
        for (Link link : links) {
            for (String end : List.of(link.from(), link.to())) {
                if (!names.contains(end)) {
                    throw new IllegalArgumentException(
                            "link " + link.name() + " joins '" + end + "', which is no body; there are " + names);
                }
            }
            if (link.from().equals(link.to())) {
                throw new IllegalArgumentException("link " + link.name() + " joins a body to itself");
            }
        }
        Set<String> reached = new HashSet<>(Set.of(base.name()));
        for (int pass = 0; pass < bodies.size(); pass++) {
            for (Link link : links) {
                if (reached.contains(link.from()) || reached.contains(link.to())
                        || link.arms().keySet().stream().anyMatch(reached::contains)) {
                    reached.add(link.from());
                    reached.add(link.to());
                    reached.addAll(link.arms().keySet());
                }
            }
        }
        for (Body body : bodies) {
            if (!reached.contains(body.name())) {
                throw new IllegalArgumentException("body '" + body.name() + "' hangs on nothing: no chain of links joins it to the base '"
                        + base.name() + "'");
            }
        }
        checkInputs(base, bodies, links, inputs);
        checkMotions(base, bodies, links, sensors);
        if (declared.equals(Optional.of(Subject.PERSON)) && (!inputs.isEmpty() || bodies.get(0).fixed())) {
            throw new IllegalArgumentException("'subject' is person, but "
                    + (inputs.isEmpty() ? "all bodies are fixed, so that the links are driven"
                            : "the measured force " + inputs.get(0).sensor() + " is an input")
                    + ": only a rig has that; say \"subject\": \"rig\"");
        }
    }

    /** Each sensor reads one body's own motion. */
    public Model(String name, Optional<String> source, char axis, Base base, List<Body> bodies, List<Link> links, List<Input> inputs,
            Optional<Subject> declared) {
        this(name, source, axis, base, bodies, links, inputs, declared, List.of());
    }

    /** Nobody says what it is. */
    public Model(String name, Optional<String> source, char axis, Base base, List<Body> bodies, List<Link> links, List<Input> inputs) {
        this(name, source, axis, base, bodies, links, inputs, Optional.empty());
    }

    /** A model that its base moves. */
    public Model(String name, Optional<String> source, char axis, Base base, List<Body> bodies, List<Link> links) {
        this(name, source, axis, base, bodies, links, List.of());
    }

    private static void checkInputs(Base base, List<Body> bodies, List<Link> links, List<Input> inputs) {
        for (Input input : inputs) {
            if (bodies.stream().noneMatch(body -> body.name().equals(input.body()) && !body.fixed())) {
                throw new IllegalArgumentException(
                        "the input " + input.sensor() + " acts on '" + input.body() + "', which is no body that can move");
            }
        }
        if (!inputs.isEmpty() && base.sensor().isPresent()) {
            throw new IllegalArgumentException(
                    "with measured forces as inputs the base '" + base.name() + "' must be at rest: its sensor null, not "
                            + base.sensor().get());
        }
        long fixed = bodies.stream().filter(Body::fixed).count();
        if (fixed > 0 && fixed < bodies.size()) {
            throw new IllegalArgumentException("either all bodies are fixed, which makes every link a driven one, or none is; fixed are "
                    + fixed + " of " + bodies.size());
        }
        for (int l = 0; l < links.size(); l++) {
            for (Law law : links.get(l).laws()) {
                int own = l;
                if (law.modulator().otherLink().filter(other -> other.link() >= links.size() || other.link() == own).isPresent()) {
                    throw new IllegalArgumentException(
                            "a law of link " + links.get(l).name() + " goes by the " + law.modulator() + "; there are " + links.size()
                                    + " links, and it must be another one");
                }
            }
        }
        for (Link link : links) {
            if (fixed > 0 && !link.from().equals(base.name()) && !link.to().equals(base.name())) {
                throw new IllegalArgumentException("link " + link.name() + " joins two fixed bodies: it cannot move");
            }
        }
    }

    private static void checkMotions(Base base, List<Body> bodies, List<Link> links, List<Sensor> sensors) {
        Set<String> names = new HashSet<>();
        bodies.forEach(body -> names.add(body.name()));
        for (Link link : links) {
            mustBe(names, link.arms().keySet(), "link " + link.name());
            if (link.arms().containsKey(link.from()) || link.arms().containsKey(link.to())) {
                throw new IllegalArgumentException(
                        "link " + link.name() + " has an arm at one of its own ends, which stretch it as they are");
            }
        }
        for (Sensor sensor : sensors) {
            mustBe(names, sensor.reads().keySet(), "the sensor " + sensor.channel());
        }
        for (Body body : bodies) {
            body.at().ifPresent(at -> motionOf(body.name()));
            body.massOf().ifPresent(other -> {
                mustBe(names, Set.of(other), "the mass of '" + body.name() + "'");
                if (bodies.stream().noneMatch(
                        each -> each.name().equals(other) && each.massOf().isEmpty() && each.mass() == body.mass() && !each.turns())) {
                    throw new IllegalArgumentException(
                            "'" + body.name() + "' has the mass of '" + other + "', which must have its own, the same");
                }
            });
            for (Channel axis : body.carried().keySet()) {
                if (!base.sensors().contains(axis)) {
                    throw new IllegalArgumentException(
                            "'" + body.name() + "' is carried by " + axis + ", which is no sensor of the base '" + base.name() + "': "
                                    + base.sensors());
                }
            }
        }
        if (bodies.get(0).fixed() && base.filter().isPresent()) {
            throw new IllegalArgumentException("driven links are told as they are, past no anti-alias filter");
        }
        if (bodies.get(0).fixed() && (!base.further().isEmpty() || !sensors.isEmpty())) {
            throw new IllegalArgumentException(
                    "driven links have one stroke, and sensors that read their force: no further axes, no further sensors");
        }
    }

    private static void mustBe(Set<String> names, Collection<String> asked, String whose) {
        asked.stream().filter(name -> !names.contains(name)).findFirst().ifPresent(name -> {
            throw new IllegalArgumentException(whose + " goes by '" + name + "', which is no body; there are " + names);
        });
    }

    /** Whether all bodies are fixed: the base's motion is the motion of every link. */
    public boolean driven() {
        return bodies.get(0).fixed();
    }

    /** What it is declared to be; undeclared a rig where links are driven or measured forces push it, else a person. */
    public Subject subject() {
        return declared.orElse(driven() || !inputs.isEmpty() ? Subject.RIG : Subject.PERSON);
    }

    /** The same, declared to be that. */
    public Model declaredAs(Subject subject) {
        return new Model(name, source, axis, base, bodies, links, inputs, Optional.of(subject), sensors);
    }

    /** The same of other bodies and links. */
    public Model with(List<Body> bodies, List<Link> links) {
        return new Model(name, source, axis, base, bodies, links, inputs, declared, sensors);
    }

    /** The same, its sensors behind that filter; as it is where none is given. */
    public Model behind(Optional<SensorFilter> filter) {
        Base passed = new Base(base.name(), base.sensor(), base.mass(), base.further(), base.at(), filter.or(base::filter));
        return new Model(name, source, axis, passed, bodies, links, inputs, declared, sensors);
    }

    /** Whether it is a rig by what its user says or, where nobody does, by what it holds. */
    public boolean isRig() {
        return subject() == Subject.RIG;
    }

    /** The sentence that says what an undeclared model is taken for, and why; empty for one that is declared. */
    public Optional<String> guess() {
        String why = driven() ? "its links are driven"
                : inputs.isEmpty() ? "its base moves it; a rig says \"subject\": \"rig\"" : "measured forces push it";
        return declared.isPresent() ? Optional.empty()
                : Optional.of("The model does not say its \"subject\"; it is taken for a " + subject().word() + ", since " + why + ".");
    }

    /** The channels that move the model: the base's sensor, or the measured forces. */
    public List<Channel> excitations() {
        List<Channel> out = new ArrayList<>(base.sensors());
        inputs.forEach(input -> out.add(input.sensor()));
        return out;
    }

    /** All that it has to do with in a recording, each once: its outputs, then what moves it. */
    public List<Channel> channels() {
        return Stream.concat(outputs().stream(), excitations().stream()).distinct().toList();
    }

    /** What rests on the base, and what is one with it [kg]. What only turns, and what is another motion of a body, adds nothing. */
    public double mass() {
        return base.mass() + bodies.stream().filter(body -> !body.turns() && body.massOf().isEmpty()).mapToDouble(Body::mass).sum();
    }

    /** Whether its base moves along one axis, which carries every body, and each link and sensor goes by its own bodies alone. */
    public boolean isAlongOneAxis() {
        return base.further().isEmpty() && sensors.isEmpty() && links.stream().allMatch(link -> link.arms().isEmpty())
                && bodies.stream().allMatch(body -> body.carried().isEmpty() && body.massOf().isEmpty() && !body.turns());
    }

    /** The key of a body's mass: kilograms, or what it takes to turn it; empty where it shares another's. */
    public Optional<String> massKey(Body body) {
        return body.massOf().isPresent() ? Optional.empty() : Optional.of(body.turns() ? "inertia_kgm2" : "mass_kg");
    }

    /** Whether a link acts about an axis: its deflection is an angle [rad], its force a moment [N m]. */
    public boolean about(Link link) {
        return index(link.to()) >= 0 && bodies.get(index(link.to())).turns();
    }

    /** The same model with only those sensors on its bodies and links that measure one of these channels. */
    public Model seenBy(Collection<Channel> channels) {
        return new Model(name, source, axis, base,
                bodies.stream().map(body -> body.sensor().filter(channels::contains).isPresent() ? body : body.unseen()).toList(),
                links.stream().map(link -> link.sensor().filter(channels::contains).isPresent() ? link : link.unseen()).toList(),
                inputs, declared, sensors.stream().filter(sensor -> channels.contains(sensor.channel())).toList());
    }

    /** Index of a body by name; -1 for the base. */
    public int index(String body) {
        for (int i = 0; i < bodies.size(); i++) {
            if (bodies.get(i).name().equals(body)) {
                return i;
            }
        }
        return -1;
    }

    /** The channels that the model's sensors predict: of bodies, of links, and those that read more than one body. */
    public List<Channel> outputs() {
        List<Channel> out = new ArrayList<>();
        bodies.forEach(body -> body.sensor().ifPresent(out::add));
        links.forEach(link -> link.sensor().ifPresent(out::add));
        sensors.forEach(sensor -> out.add(sensor.channel()));
        return out;
    }

    /** The model in numbers; a hidden mode becomes a further body and link behind the model's own. */
    public Assembly assembly() {
        List<int[]> ends = new ArrayList<>();
        List<Double> stiffness = new ArrayList<>();
        List<Double> damping = new ArrayList<>();
        List<Double> mass = new ArrayList<>();
        List<LawAt> laws = new ArrayList<>();
        List<Assembly.DriveAt> drives = new ArrayList<>();
        List<Assembly.Output> outputs = new ArrayList<>();
        for (Link link : links) {
            // The base can only be a lower end; a link drawn downwards to it is the same link turned round.
            boolean turned = index(link.to()) < 0;
            int place = ends.size();
            ends.add(new int[] {index(turned ? link.to() : link.from()), index(turned ? link.from() : link.to())});
            stiffness.add(link.stiffness());
            damping.add(link.damping());
            link.laws().forEach(law -> laws.add(new LawAt(place, law)));
            link.drives().forEach(drive -> drives.add(new Assembly.DriveAt(place, drive)));
        }
        for (int i = 0; i < bodies.size(); i++) {
            Body body = bodies.get(i);
            int place = i;
            mass.add(body.mass());
            body.forces().forEach(force -> drives.add(new Assembly.DriveAt(place, force)));
            inputs.stream().filter(input -> input.body().equals(body.name()))
                    .forEach(input -> drives.add(new Assembly.DriveAt(place, new Drive.Measured(input.sensor(), input.offset()))));
            body.sensor().ifPresent(sensor -> outputs
                    .add(new Assembly.Output(place, reading(sensor), body.faults(), Row.of(place), mount(body.name(), body.at()))));
        }
        for (int i = 0; i < bodies.size(); i++) {
            int place = i;
            bodies.get(i).hidden().ifPresent(hidden -> {
                hidden.stiffening().ifPresent(law -> laws.add(new LawAt(ends.size(), law)));
                ends.add(new int[] {place, mass.size()});
                stiffness.add(hidden.stiffness());
                damping.add(hidden.damping());
                mass.add(hidden.mass());
            });
        }
        for (int l = 0; l < links.size(); l++) {
            int place = l;
            links.get(l).sensor()
                    .ifPresent(sensor -> outputs.add(new Assembly.Output(place, Assembly.Reading.LINK_FORCE, links.get(place).faults())));
        }
        for (Sensor sensor : sensors) {
            outputs.add(new Assembly.Output(index(sensor.body()), reading(sensor.channel()), sensor.faults(), row(sensor.reads()),
                    mount(sensor.body(), sensor.at())));
        }
        Structure structure = new Structure(ends.stream().mapToInt(e -> e[0]).toArray(), ends.stream().mapToInt(e -> e[1]).toArray(),
                numbers(stiffness), numbers(damping), numbers(mass), driven(), kinematics(ends));
        return new Assembly(structure, laws, drives, outputs);
    }

    /** @param ends of the links, those of hidden modes behind the model's own */
    private Kinematics kinematics(List<int[]> ends) {
        int axes = Math.max(1, base.sensors().size());
        double[][] carried = new double[bodies.size()][axes];
        int[] massOf = new int[bodies.size()];
        for (int i = 0; i < bodies.size(); i++) {
            Body body = bodies.get(i);
            carried[i][0] = body.carried().isEmpty() ? 1 : 0;
            for (int axis = 0; axis < base.sensors().size(); axis++) {
                carried[i][axis] += body.carried().getOrDefault(base.sensors().get(axis), 0.0);
            }
            massOf[i] = body.massOf().map(this::index).orElse(i);
        }
        List<Row> stretch = new ArrayList<>();
        for (int l = 0; l < links.size(); l++) {
            Row row = Row.between(ends.get(l)[0], ends.get(l)[1]);
            double sense = index(links.get(l).to()) < 0 ? -1 : 1;   // a link that is turned round
            for (Map.Entry<String, Double> arm : links.get(l).arms().entrySet()) {
                row = row.plus(index(arm.getKey()), sense * arm.getValue());
            }
            stretch.add(row);
        }
        Kinematics own = new Kinematics(stretch, carried, massOf, plane());
        for (int l = links.size(); l < ends.size(); l++) {
            own = own.riding(ends.get(l)[0]);
        }
        return own;
    }

    /** Where everything is, in a plane; empty where that is not said of the base. */
    private Optional<Plane> plane() {
        return base.at().map(origin -> {
            int[] axes = Arrays.stream(Plane.Motion.values()).mapToInt(motion -> IntStream.range(0, base.sensors().size())
                    .filter(axis -> motion == motionOf(base.sensors().get(axis))).findFirst().orElse(-1)).toArray();
            List<Plane.Rigid> rigid = rigid().stream().map(name -> new Plane.Rigid(Arrays.stream(Plane.Motion.values())
                    .mapToInt(motion -> index(name + suffix(motion))).toArray(), centre(name).x(), centre(name).z())).toList();
            List<Plane.Joint> joints = new ArrayList<>();
            for (int l = 0; l < links.size(); l++) {
                Link link = links.get(l);
                int place = l;
                link.at().ifPresent(at -> joints.add(new Plane.Joint(place, motionOf(link.to()), rigid().indexOf(whole(link.from())),
                        rigid().indexOf(whole(link.to())), at.x(), at.z())));
            }
            return new Plane(new double[] {origin.x(), origin.z()}, axes, rigid, joints);
        });
    }

    /** Names of the bodies of which there are motions in a plane. */
    private List<String> rigid() {
        return bodies.stream().filter(body -> body.at().isPresent()).map(body -> whole(body.name())).distinct().toList();
    }

    private Point centre(String rigid) {
        return bodies.stream().filter(body -> body.at().isPresent() && whole(body.name()).equals(rigid)).findFirst().flatMap(Body::at)
                .orElseThrow();
    }

    private Optional<Plane.Mount> mount(String motion, Optional<Point> at) {
        return base.at().isEmpty() ? Optional.empty() : at.map(point -> {
            Point centre = centre(whole(motion));
            return new Plane.Mount(rigid().indexOf(whole(motion)), motionOf(motion), point.x() - centre.x(), point.z() - centre.z());
        });
    }

    /** The body of which something is a motion; itself, if it has the name of none. */
    public static String whole(String motion) {
        int dot = motion.lastIndexOf('.');
        return dot < 0 ? motion : motion.substring(0, dot);
    }

    /** End of a motion's name. */
    static String suffix(Plane.Motion motion) {
        return "." + motion.name().toLowerCase(Locale.ROOT);
    }

    private static Plane.Motion motionOf(String name) {
        return Arrays.stream(Plane.Motion.values()).filter(motion -> name.endsWith(suffix(motion))).findFirst()
                .orElseThrow(() -> new IllegalArgumentException("'" + name + "' is in a plane: its name must end in .x, .z or .pitch"));
    }

    /** What a sensor in a plane reads. */
    static Plane.Motion motionOf(Channel sensor) {
        boolean turning = sensor.quantity() == Quantity.ANGULAR_RATE || sensor.quantity() == Quantity.ANGLE;
        return turning ? Plane.Motion.PITCH : sensor.axis() == 'x' ? Plane.Motion.X : Plane.Motion.Z;
    }

    private Row row(Map<String, Double> reads) {
        Row out = Row.of(-1);
        for (Map.Entry<String, Double> each : reads.entrySet()) {
            out = out.plus(index(each.getKey()), each.getValue());
        }
        return out;
    }

    private static double[] numbers(List<Double> list) {
        return list.stream().mapToDouble(Double::doubleValue).toArray();
    }

    private static Assembly.Reading reading(Channel sensor) {
        return switch (sensor.quantity()) {
            case ACCELERATION -> Assembly.Reading.ACCELERATION;
            case VELOCITY, ANGULAR_RATE -> Assembly.Reading.VELOCITY;
            case POSITION, ANGLE -> Assembly.Reading.POSITION;
            default -> throw new DataFault("a body's sensor reads acc, vel or pos, gyr or ang where it turns: " + sensor
                    + (sensor.quantity() == Quantity.SPECIFIC_FORCE ? "; remove gravity first (accg to acc)" : ""));
        };
    }
}

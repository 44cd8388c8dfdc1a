package wbv.body;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Quantity;

/**
 * A lumped model as its user writes it: a base, bodies, and links between them, on one axis.
 *
 * <p>It is moved either by its base's measured motion, or, the base at rest, by measured forces on bodies. Where all bodies are
 * fixed, the links are driven: nothing swings, and what the links carry follows from the base's motion alone.
 *
 * @param source where the values come from, and how sure they are
 * @param inputs measured forces; none where the base moves
 * @param declared what its user says it is; where nobody does, {@link #subject} goes by what it holds
 */
public record Model(String name, Optional<String> source, char axis, Base base, List<Body> bodies, List<Link> links, List<Input> inputs,
                    Optional<Subject> declared) {

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
     * @param sensor its measured acceleration, velocity or position; none for a base at rest
     * @param mass   what of the sitter moves with it rigidly [kg], &gt;= 0: part of what it carries, of no motion
     */
    public record Base(String name, Optional<Channel> sensor, double mass) {
        /** A base that nothing of the sitter is one with. */
        public Base(String name, Optional<Channel> sensor) {
            this(name, sensor, 0);
        }

        public Base {
            Check.notNegative("mass of " + name, "kg", mass);
        }
    }

    /** A measured force. @param body on which it acts @param sensor what measures it [N] @param offset what that reads at no force [N] */
    public record Input(String body, Channel sensor, double offset) {
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
     * A rigid body. @param mass [kg], &gt; 0 @param sensor what measures it @param faults of that sensor
     *
     * @param hidden a mass on a spring that nobody sees @param forces on the body that nobody measured
     * @param fixed whether it is held at rest; its mass then plays no part
     */
    public record Body(String name, double mass, Optional<Channel> sensor, List<SensorFault> faults, Optional<HiddenMode> hidden,
                       List<Drive> forces, boolean fixed) {
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
        }

        private Body unseen() {
            return new Body(name, mass, Optional.empty(), List.of(), hidden, forces, fixed);
        }
    }

    /** A mass that rides on a body. @param mass [kg] @param frequency of its own [Hz] @param dampingRatio of its own [1], all &gt; 0 */
    public record HiddenMode(@Key("mass_kg") double mass, @Key("frequency_hz") double frequency,
                             @Key("damping_ratio") double dampingRatio) {
        public HiddenMode {
            Check.positive("hidden mass", "kg", mass);
            Check.positive("hidden mode's frequency", "Hz", frequency);
            Check.positive("hidden mode's damping ratio", "1", dampingRatio);
        }

        /** Stiffness of its spring [N/m]. */
        public double stiffness() {
            double omega = 2 * Math.PI * frequency;
            return mass * omega * omega;
        }

        /** Damping of its dashpot [N s/m]. */
        public double damping() {
            return 2 * dampingRatio * 2 * Math.PI * frequency * mass;
        }
    }

    /**
     * A spring and a dashpot between two bodies, and what else acts there.
     *
     * @param stiffness [N/m], &gt;= 0 @param damping [N s/m], &gt;= 0 @param sensor what measures the force in it @param faults of that sensor
     */
    public record Link(String from, String to, double stiffness, double damping, Optional<Channel> sensor, List<Law> laws,
                       List<Drive> drives, List<SensorFault> faults) {
        public Link(String from, String to, double stiffness, double damping, Optional<Channel> sensor, List<Law> laws, List<Drive> drives) {
            this(from, to, stiffness, damping, sensor, laws, drives, List.of());
        }

        public Link {
            Check.notNegative("stiffness of " + from + "-" + to, "N/m", stiffness);
            Check.notNegative("damping of " + from + "-" + to, "N s/m", damping);
            laws = List.copyOf(laws);
            drives = List.copyOf(drives);
            faults = List.copyOf(faults);
        }

        private Link unseen() {
            return new Link(from, to, stiffness, damping, Optional.empty(), laws, drives);
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
                    throw new IllegalArgumentException("link " + link.name() + " joins '" + end + "', which is no body; there are " + names);
                }
            }
            if (link.from().equals(link.to())) {
                throw new IllegalArgumentException("link " + link.name() + " joins a body to itself");
            }
        }
        Set<String> reached = new HashSet<>(Set.of(base.name()));
        for (int pass = 0; pass < bodies.size(); pass++) {
            for (Link link : links) {
                if (reached.contains(link.from()) || reached.contains(link.to())) {
                    reached.add(link.from());
                    reached.add(link.to());
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
        if (declared.equals(Optional.of(Subject.PERSON)) && (!inputs.isEmpty() || bodies.get(0).fixed())) {
            throw new IllegalArgumentException("'subject' is person, but " + (inputs.isEmpty() ? "all bodies are fixed, so that the links are driven"
                    : "the measured force " + inputs.get(0).sensor() + " is an input") + ": only a rig has that; say \"subject\": \"rig\"");
        }
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
                throw new IllegalArgumentException("the input " + input.sensor() + " acts on '" + input.body() + "', which is no body that can move");
            }
        }
        if (!inputs.isEmpty() && base.sensor().isPresent()) {
            throw new IllegalArgumentException("with measured forces as inputs the base '" + base.name() + "' must be at rest: its sensor null, not "
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
                    throw new IllegalArgumentException("a law of link " + links.get(l).name() + " goes by the " + law.modulator() + "; there are " + links.size()
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

    /** Whether all bodies are fixed: the base's motion is the motion of every link. */
    public boolean driven() {
        return bodies.get(0).fixed();
    }

    /** What it is declared to be; undeclared a rig where links are driven or measured forces push it, else a person. */
    public Subject subject() {
        return declared.orElse(driven() || !inputs.isEmpty() ? Subject.RIG : Subject.PERSON);
    }

    public boolean isRig() {
        return subject() == Subject.RIG;
    }

    /** The sentence that says what an undeclared model is taken for, and why; empty for one that is declared. */
    public Optional<String> guess() {
        String why = driven() ? "its links are driven" : inputs.isEmpty() ? "its base moves it; a rig says \"subject\": \"rig\"" : "measured forces push it";
        return declared.isPresent() ? Optional.empty() : Optional.of("The model does not say its \"subject\"; it is taken for a " + subject().word() + ", since " + why + ".");
    }

    /** The channels that move the model: the base's sensor, or the measured forces. */
    public List<Channel> excitations() {
        List<Channel> out = new ArrayList<>();
        base.sensor().ifPresent(out::add);
        inputs.forEach(input -> out.add(input.sensor()));
        return out;
    }

    /** What rests on the base, and what is one with it [kg]. */
    public double mass() {
        return base.mass() + bodies.stream().mapToDouble(Body::mass).sum();
    }

    /** The same model with only those sensors on its bodies and links that measure one of these channels. */
    public Model seenBy(Collection<Channel> channels) {
        return new Model(name, source, axis, base,
                bodies.stream().map(body -> body.sensor().filter(channels::contains).isPresent() ? body : body.unseen()).toList(),
                links.stream().map(link -> link.sensor().filter(channels::contains).isPresent() ? link : link.unseen()).toList(),
                inputs, declared);
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

    /** The channels that the model's sensors predict, bodies first, then links. */
    public List<Channel> outputs() {
        List<Channel> out = new ArrayList<>();
        bodies.forEach(body -> body.sensor().ifPresent(out::add));
        links.forEach(link -> link.sensor().ifPresent(out::add));
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
            body.sensor().ifPresent(sensor -> outputs.add(new Assembly.Output(place, reading(sensor), body.faults())));
        }
        for (int i = 0; i < bodies.size(); i++) {
            int place = i;
            bodies.get(i).hidden().ifPresent(hidden -> {
                ends.add(new int[] {place, mass.size()});
                stiffness.add(hidden.stiffness());
                damping.add(hidden.damping());
                mass.add(hidden.mass());
            });
        }
        for (int l = 0; l < links.size(); l++) {
            int place = l;
            links.get(l).sensor().ifPresent(sensor -> outputs.add(new Assembly.Output(place, Assembly.Reading.LINK_FORCE, links.get(place).faults())));
        }
        Structure structure = new Structure(ends.stream().mapToInt(e -> e[0]).toArray(), ends.stream().mapToInt(e -> e[1]).toArray(),
                numbers(stiffness), numbers(damping), numbers(mass), driven());
        return new Assembly(structure, laws, drives, outputs);
    }

    private static double[] numbers(List<Double> list) {
        return list.stream().mapToDouble(Double::doubleValue).toArray();
    }

    private static Assembly.Reading reading(Channel sensor) {
        return switch (sensor.quantity()) {
            case ACCELERATION -> Assembly.Reading.ACCELERATION;
            case VELOCITY -> Assembly.Reading.VELOCITY;
            case POSITION -> Assembly.Reading.POSITION;
            default -> throw new DataFault("a body's sensor reads acc, vel or pos: " + sensor
                    + (sensor.quantity() == Quantity.SPECIFIC_FORCE ? "; remove gravity first (accg to acc)" : ""));
        };
    }
}

package wbv.body.simulate;

import java.util.List;
import java.util.Optional;
import java.util.function.IntFunction;
import java.util.stream.IntStream;
import wbv.body.Assembly;
import wbv.body.Drive;
import wbv.body.LawAt;
import wbv.body.Plane;
import wbv.body.Row;
import wbv.body.SensorFault;
import wbv.body.Spectra;
import wbv.body.Structure;
import wbv.body.law.Law;
import wbv.body.number.Numbers;

/**
 * Simulates an {@link Assembly} on an {@link Excitation}: the linear part in the frequency domain, the laws by
 * {@link FreeRun}, whose forces are then put back as inputs of the linear part, so that every output has passed the same band
 * limit, whatever the law did above it.
 */
public final class Simulator {

    /** Part of a link's own stiffness or damping that its equivalent keeps, whatever a law takes. */
    private static final double LEAST = 1e-3;

    /**
     * What may be left of the motion's accelerations when what goes beyond small motions is found: a hundredth of what sensors of a
     * hundredth's noise hide.
     */
    private static final double UNBENT = 1e-4;
    /** Rounds in which it is found at most: one that moves by a tenth of itself leaves a tenth of the one before. */
    private static final int BENDS = 6;

    private final Excitation excitation;

    /** A simulator of any models, on one excitation. */
    public Simulator(Excitation excitation) {
        this.excitation = excitation;
    }

    /** The outputs as series at the recording's rate, by output, each {@link Excitation#samples} long, in its own unit. */
    public double[][] outputs(Assembly assembly) {
        Response response = run(assembly, false);
        if (response.diverged()) {
            throw new wbv.recording.DataFault("the simulation leaves all bounds: a law of the model is unstable with these values");
        }
        return java.util.Arrays.stream(response.outputs()).map(excitation::series).toArray(double[][]::new);
    }

    /**
     * What a simulation gave.
     *
     * @param outputs  spectrum by output, in its own unit
     * @param slopes   derivative of each output to each parameter of {@link Assembly#values}, in the units of both: spectra by parameter
     *                 and output; those not asked for are empty
     * @param forces   spectrum of the force of each law [N]
     * @param stretch  spectrum of the relative displacement of each link [m]
     * @param diverged whether the free run left all bounds: then nothing here means anything
     * @param bends    what goes beyond small motions; empty where nothing does
     * @param recorded part of each output that its sensor's other channels make, as spectra by output, in its own unit, as they were
     *                 recorded: late as they are; empty where they make none
     */
    public record Response(double[][] outputs, double[][][] slopes, double[][] forces, double[][] stretch, boolean diverged,
            Optional<Bends> bends, double[][] recorded) {}

    /**
     * What goes beyond small motions in a motion, hundredths of it: what it does to the bodies, and what sensors read of it.
     *
     * @param forces on the coordinates beside those of first order [N, N m], spectra
     * @param readings spectra by output, in its own unit; empty where nothing. None copied
     */
    public record Bends(double[][] forces, double[][] readings) {}

    /** Simulates, with the derivatives to every parameter if {@code sensitivities}. */
    public Response run(Assembly assembly, boolean sensitivities) {
        return run(assembly, sensitivities, Optional.empty());
    }

    /**
     * The same with what goes beyond small motions as it was found for an assembly nearby, which is most of the work.
     *
     * @param bends empty: found anew
     */
    public Response run(Assembly assembly, boolean sensitivities, Optional<Bends> bends) {
        return run(assembly, Sensitivities.all(sensitivities), bends);
    }

    /** The same with some derivatives. Driven links give all of them where any are asked for. */
    public Response run(Assembly assembly, Sensitivities sensitivities, Optional<Bends> bends) {
        if (assembly.structure().held()) {
            return new DrivenLinks(excitation, assembly, sensitivities.any()).response();
        }
        return new Run(assembly, sensitivities, bends).response();
    }

    /**
     * What each output makes of the input, linear laws and sensor filters included, other laws, drives and offsets left out: spectra by
     * output. The input is the base's acceleration, or a unit of every measured force; driven links make nothing of their stroke's noise.
     */
    public double[][] transmissibility(Assembly assembly) {
        return transmissibility(assembly, 0);
    }

    /** The same of one of the axes along which the base moves; measured forces and driven links have the first alone. */
    public double[][] transmissibility(Assembly assembly, int axis) {
        if (assembly.structure().held()) {
            return new double[assembly.outputs().size()][2 * excitation.omega().length];
        }
        List<Integer> pushed = assembly.drives().stream().filter(at -> at.drive() instanceof Drive.Measured).map(Assembly.DriveAt::place)
                .toList();
        if (!pushed.isEmpty()) {
            Linearised linear = linearised(assembly);
            double[][] out = linear.ofBodyForce(pushed.get(0));
            for (int body : pushed.subList(1, pushed.size())) {
                double[][] more = linear.ofBodyForce(body);
                IntStream.range(0, out.length).forEach(o -> Spectra.add(out[o], more[o], 1));
            }
            return out;
        }
        return new Simulator(excitation.unit(axis)).run(transparent(assembly), false).outputs();
    }

    /**
     * What the outputs of the linear part would make of a base that moved along one of its axes as it did along another, as spectra by
     * output, in its own unit.
     *
     * @param axis along which
     * @param as as which; the same for what it did
     */
    public double[][] ofAxis(Assembly assembly, int axis, int as) {
        return java.util.Arrays.stream(transmissibility(assembly, axis)).map(way -> Spectra.product(way, excitation.base(as)))
                .toArray(double[][]::new);
    }

    /** How far each link's lower end is lifted beside the motion of the bodies [m], as spectra; empty where nothing lifts it. */
    private double[][] lifts(Assembly assembly) {
        DriveForces drives = new DriveForces(excitation, assembly, link -> new double[0]);
        double[][] out = new double[assembly.structure().links()][0];
        for (int d = 0; d < assembly.drives().size(); d++) {
            double[] lift = drives.lift(d);
            if (lift.length > 0) {
                int link = assembly.drives().get(d).place();
                Spectra.add(lift, out[link], 1);
                out[link] = lift;
            }
        }
        return out;
    }

    /**
     * The true reading of which a sensor's fault made another, as a spectrum in its own unit. Empty where that cannot be told, as of a
     * reading that was clipped.
     *
     * @param read spectrum of the faulty reading, in its own unit. Not modified.
     */
    public Optional<double[]> undone(SensorFault fault, double[] read) {
        return new Sensing(excitation).undone(fault, read);
    }

    /**
     * The linear assembly that comes nearest in the motion of this excitation: each law that is not linear gives way to the stiffness and
     * the damping that make up for most of its force (equivalent linearisation, Caughey 1963). What acts beside the excitation and is
     * small, such as noise, meets these and not the stiffness at rest. The assembly itself where all is linear, or where its run leaves all
     * bounds.
     */
    public Assembly equivalent(Assembly assembly) {
        if (assembly.laws().stream().allMatch(at -> at.law().isLinear()) || assembly.structure().held()) {
            return assembly;
        }
        Response response = run(assembly, false);
        if (response.diverged()) {
            return assembly;
        }
        double[] values = assembly.structure().values();
        int links = assembly.structure().links();
        for (int i = 0; i < assembly.laws().size(); i++) {
            LawAt at = assembly.laws().get(i);
            if (!at.law().isLinear()) {
                double[] own = Spectra.stiffnessAndDamping(excitation.omega(), response.forces()[i], response.stretch()[at.link()]);
                values[at.link()] += own[0];
                values[links + at.link()] += own[1];
            }
        }
        for (int l = 0; l < 2 * links; l++) {
            values[l] = Math.max(values[l], LEAST * assembly.structure().values()[l]);
        }
        List<LawAt> linear = assembly.laws().stream().filter(at -> at.law().isLinear()).toList();
        return new Assembly(assembly.structure().with(values), linear, assembly.drives(), assembly.outputs());
    }

    /** The linear part of an assembly, solved once, to be asked what forces in its links do. */
    public Linearised linearised(Assembly assembly) {
        return new Linearised(transparent(assembly));
    }

    /** What the outputs make of a force in a link beside everything else that is linear; base motion left out. */
    public final class Linearised {
        private final Run run;

        private Linearised(Assembly assembly) {
            run = new Run(assembly);
        }

        /**
         * What the outputs make of a force in a link.
         *
         * @param force at the free run's rate, by sample [N], pulling the link's ends together. Not modified.
         * @return spectra by output, in its own unit
         */
        public double[][] answer(int link, double[] force) {
            return run.answer(link, -1, excitation.spectrumOfForce(force), false);
        }

        /**
         * As {@link #answer}, of a force as a spectrum.
         *
         * @param force spectrum of one [N], pulling the link's ends together. Not modified.
         * @return spectra by output, in its own unit
         */
        public double[][] answerTo(int link, double[] force) {
            return run.answer(link, -1, force, false);
        }

        /**
         * As {@link #answerTo}, of a force on a body, or a moment.
         *
         * @param force spectrum of one [N] or [N m]. Not modified.
         * @return spectra by output, in its own unit
         */
        public double[][] answerOn(int body, double[] force) {
            return run.answer(-1, body, force, false);
        }

        /** What a force of 1 N, or a moment of 1 N m, in a link does to the outputs at every line, spectra by output, in its own unit. */
        public double[][] ofLinkForce(int link) {
            return run.answer(link, -1, excitation.unit().baseSpectrum(), true);
        }

        /** What a force of 1 N, or a moment of 1 N m, on a body does to the outputs at every line, spectra by output, in its own unit. */
        public double[][] ofBodyForce(int body) {
            return run.answer(-1, body, excitation.unit().baseSpectrum(), true);
        }
    }

    private Assembly transparent(Assembly assembly) {
        List<LawAt> laws = assembly.laws().stream().filter(at -> at.law().isLinear()).toList();
        List<Assembly.Output> outputs = assembly.outputs().stream().map(output -> output.with(
                output.faults().stream().flatMap(fault -> fault.filter(excitation.samples() / excitation.rate()).stream()).toList()))
                .toList();
        return new Assembly(assembly.structure(), laws, List.of(), outputs);
    }

    /** One simulation. */
    private final class Run {
        private final Assembly assembly;
        private final Structure structure;
        private final Sensitivities sensitivities;
        /** Parameters to which derivatives are asked for: the first, and the one after the last. */
        private final int from;
        private final int count;
        private final boolean linear;
        private final SpectralResponse response = new SpectralResponse(excitation);
        private final double[][] q;
        private final double[][] lawForce;
        private final DriveForces drives;
        private final double[][] driveForce;
        private boolean diverged;
        private final Optional<Bends> bends;
        /**
         * Derivatives of what all laws of a link carry [parameter][law] as spectra, at the first of them, at the others nothing; only for a
         * free run.
         */
        private final double[][][] lawSlope;

        Run(Assembly assembly, Sensitivities sensitivities, Optional<Bends> given) {
            this.assembly = assembly;
            this.structure = assembly.structure();
            this.sensitivities = sensitivities;
            this.count = sensitivities.any() ? assembly.values().length : 0;
            this.from = sensitivities.from(structure.parameters());
            this.linear = assembly.laws().stream().allMatch(at -> at.law().isLinear());
            response.solve(structure, further());
            drives = new DriveForces(excitation, assembly, response::stiffness);
            driveForce = IntStream.range(0, assembly.drives().size()).mapToObj(drives::of).toArray(double[][]::new);
            q = response.motion();
            for (int d = 0; d < driveForce.length; d++) {
                addDrive(d, driveForce[d], q);
            }
            excitation.pushes().forEach((body, force) -> response.addBodyForce(body, force, 1, q));
            lawForce = new double[assembly.laws().size()][];
            lawSlope = new double[linear ? 0 : count][lawForce.length][];
            if (linear) {
                for (int i = 0; i < lawForce.length; i++) {
                    LawAt at = assembly.laws().get(i);
                    lawForce[i] = Spectra.product(dynamicStiffness(at.law()), deflection(at.link()));
                }
            } else {
                freeRun();
                for (int i = 0; i < lawForce.length; i++) {
                    response.addLinkForce(assembly.laws().get(i).link(), lawForce[i], q);
                }
            }
            given.ifPresent(known -> push(known.forces()));
            bends = given.or(() -> structure.kinematics().plane().filter(plane -> !excitation.isUnit() && !diverged).map(this::bend));
        }

        /** Adds what forces on the coordinates make of the motion. */
        private void push(double[][] forces) {
            IntStream.range(0, forces.length).forEach(b -> response.addBodyForce(b, forces[b], 1, q));
        }

        /**
         * Adds what goes beyond small motions, as the motion makes it: a part of some hundredths of it, found again with what it changes of
         * itself. Derivatives, and what laws that are not linear carry, stay those of small motions.
         */
        private Bends bend(Plane plane) {
            double[][] small = java.util.Arrays.stream(q).map(double[]::clone).toArray(double[][]::new);
            BeyondFirstOrder there = new BeyondFirstOrder(plane, excitation, structure);
            double all = accelerating(small, new double[0][]);
            double before = all;
            double[][] forces = new double[0][];
            for (int round = 0; round < BENDS; round++) {
                there.moves(q);
                forces = there.forces(IntStream.range(0, structure.links()).mapToObj(l -> linkForce(l, q, -1)).toArray(double[][]::new));
                double[][] last = java.util.Arrays.stream(q).map(double[]::clone).toArray(double[][]::new);
                IntStream.range(0, q.length).forEach(b -> System.arraycopy(small[b], 0, q[b], 0, q[b].length));
                java.util.Arrays.stream(forces).forEach(excitation::filtered);
                push(forces);
                double moved = accelerating(q, last);
                if (moved * moved <= UNBENT * all * before) {
                    break;
                }
                before = moved;
            }
            there.moves(q);
            there.accelerates(q);
            return new Bends(forces,
                    assembly.outputs().stream().map(output -> output.mount().map(mount -> excitation.filtered(there.reading(mount)))
                            .orElseGet(() -> new double[0])).toArray(double[][]::new));
        }

        /**
         * Square root of the energy of acceleration, the mass times the square of the acceleration (Appell 1900), of what a motion has
         * beside another.
         */
        private double accelerating(double[][] motion, double[][] beside) {
            double[] omega = excitation.omega();
            double sum = 0;
            for (int b = 0; b < motion.length; b++) {
                double own = 0;
                for (int i = 0; i < motion[b].length; i++) {
                    double apart = omega[i / 2] * omega[i / 2] * (motion[b][i] - (beside.length == 0 ? 0 : beside[b][i]));
                    own += apart * apart;
                }
                sum += structure.mass()[b] * own;
            }
            return Math.sqrt(sum);
        }

        /** Solved, but nothing acts yet. */
        Run(Assembly assembly) {
            this.assembly = assembly;
            this.structure = assembly.structure();
            this.sensitivities = Sensitivities.NONE;
            this.count = 0;
            this.from = 0;
            this.linear = true;
            response.solve(structure, further());
            drives = new DriveForces(excitation, assembly, response::stiffness);
            bends = Optional.empty();
            driveForce = new double[0][];
            q = new double[0][];
            lawForce = new double[0][];
            lawSlope = new double[0][][];
        }

        /**
         * What the outputs make of a force in a link, or on a body where the link is -1.
         *
         * @param steady line by line, as a frequency response; else from rest
         */
        double[][] answer(int link, int body, double[] force, boolean steady) {
            double[][] motion = new double[structure.bodies()][2 * excitation.omega().length];
            Row pulled = link >= 0 ? structure.stretch(link) : Row.of(body);
            for (int i = 0; i < pulled.at().length; i++) {
                addForce(pulled.at()[i], force, link >= 0 ? -pulled.by()[i] : 1, steady, motion);
            }
            Sensing sensing = new Sensing(excitation);
            double[][] out = new double[assembly.outputs().size()][];
            for (int o = 0; o < out.length; o++) {
                Assembly.Output output = assembly.outputs().get(o);
                // Read as the derivative to a parameter that nothing else depends on: the base is left out.
                out[o] = read(output, motion, assembly.values().length);
                if (output.reading() == Assembly.Reading.LINK_FORCE && output.place() == link) {
                    Spectra.add(out[o], force, 1);
                }
                for (SensorFault each : output.faults()) {
                    out[o] = sensing.apply(each, out[o], new double[0][], 0);
                }
            }
            return out;
        }

        private void addForce(int body, double[] force, double factor, boolean steady, double[][] motion) {
            if (steady) {
                response.addSteady(body, force, factor, motion);
            } else {
                response.addBodyForce(body, force, factor, motion);
            }
        }

        Response response() {
            int asked = Math.max(0, count - from);
            double[][][] motionSlopes = IntStream.range(0, asked).mapToObj(p -> motionSlope(from + p)).toArray(double[][][]::new);
            Sensing sensing = new Sensing(excitation);
            int outputs = assembly.outputs().size();
            double[][] out = new double[outputs][];
            double[][][] slopes = new double[count][outputs][];
            for (int o = 0; o < outputs; o++) {
                Assembly.Output output = assembly.outputs().get(o);
                double[] reading = read(output, q, -1);
                Spectra.add(reading, bends.isPresent() ? bends.get().readings()[o] : new double[0], 1);
                double[][] readingSlopes = new double[asked][];
                for (int p = 0; p < asked; p++) {
                    readingSlopes[p] = read(output, motionSlopes[p], from + p);
                }
                out[o] = sensing.report(assembly, o, reading, readingSlopes, from);
                for (int p = 0; p < asked; p++) {
                    slopes[from + p][o] = readingSlopes[p];
                }
            }
            double[][] stretch = IntStream.range(0, structure.links()).mapToObj(this::deflection).toArray(double[][]::new);
            return new Response(out, slopes, lawForce, stretch, diverged, bends,
                    IntStream.range(0, outputs).mapToObj(o -> sensing.recorded(assembly, o)).toArray(double[][]::new));
        }

        /** The relative displacement of a link as springs and laws see it, a new spectrum: less what lifts its lower end. */
        private double[] deflection(int link) {
            double[] out = response.stretch(link, q);
            if (driveForce.length > 0) {
                Spectra.add(out, lifts(assembly)[link], -1);
            }
            return out;
        }

        /** Dynamic stiffness that linear laws add to their links; nothing if a free run will give their forces. */
        private double[][] further() {
            double[][] further = new double[structure.links()][0];
            for (LawAt at : linear ? assembly.laws() : List.<LawAt>of()) {
                double[] own = dynamicStiffness(at.law());
                if (further[at.link()].length == 0) {
                    further[at.link()] = own;
                } else {
                    Spectra.add(further[at.link()], own, 1);
                }
            }
            return further;
        }

        private double[] dynamicStiffness(Law law) {
            double[] omega = excitation.omega();
            double[] out = new double[2 * omega.length];
            double[] z = new double[2];
            for (int k = 0; k < omega.length; k++) {
                law.dynamicStiffness(omega[k], z);
                out[2 * k] = z[0];
                out[2 * k + 1] = z[1];
            }
            return out;
        }

        private void addDrive(int d, double[] force, double[][] motion) {
            Assembly.DriveAt at = assembly.drives().get(d);
            if (at.drive() instanceof Drive.Launch launch) {
                response.addLaunch(at.place(), launch.velocity(), motion);
            } else if (at.drive().actsOnBody()) {
                response.addBodyForce(at.place(), force, 1, motion);
            } else {
                response.addLinkForce(at.place(), force, motion);
            }
        }

        private void freeRun() {
            double[][] known = driveForce.length == 0 && excitation.pushes().isEmpty() ? new double[0][] : bodySeries(driveForce, -1);
            int moving = sensitivities.any() ? assembly.faultIndex(0, 0) : 0;   // what a sensor does moves nothing
            double[][][] knownSlope = new double[Math.max(0, moving - from)][0][];
            for (int p = from; p < moving && driveForce.length > 0; p++) {
                double[][] slopes = new double[driveForce.length][];
                boolean any = false;
                for (int d = 0; d < slopes.length; d++) {
                    slopes[d] = drives.slope(d, p);
                    any |= slopes[d].length > 0 || launch(d, p) != 0;
                }
                knownSlope[p - from] = any ? bodySeries(slopes, p) : new double[0][];
            }
            FreeRun.Run result = freeRun(sensitivities, new Modulations(excitation).of(assembly.laws()))
                    .lifted(lift(moving)).run(excitation.fineBase(), known, sensitivities.any(), knownSlope);
            diverged = result.diverged() >= 0;
            for (int i = 0; i < lawForce.length; i++) {
                lawForce[i] = excitation.spectrumOfForce(result.force()[i]);
                int[] together = sameLink(i);
                for (int p = from; p < count; p++) {
                    lawSlope[p][i] = p < moving && together[0] == i ? excitation.spectrumOfForce(sum(result.slope(), together, p - from))
                            : new double[0];
                }
            }
        }

        /**
         * What lifts the links in a free run, from nothing at its start: there a link is at rest with its lower end where it is.
         *
         * @param moving parameters that move anything
         */
        private Lift lift(int moving) {
            Lift lift = Lift.none(structure.links(), Math.max(0, moving - from));
            for (int d = 0; d < driveForce.length; d++) {
                int link = assembly.drives().get(d).place();
                raise(drives.lift(d), link, lift.height(), lift.rate());
                for (int p = from; p < moving; p++) {
                    raise(drives.liftSlope(d, p), link, lift.heightSlope()[p - from], lift.rateSlope()[p - from]);
                }
            }
            return lift;
        }

        /**
         * Adds to how a link is lifted.
         *
         * @param by spectrum [m]; empty where nothing
         * @param height by link. Modified.
         * @param rate by link. Modified.
         */
        private void raise(double[] by, int link, double[][] height, double[][] rate) {
            if (by.length == 0) {
                return;
            }
            double[] risen = excitation.fineSeries(by);
            double start = risen[0];
            java.util.Arrays.setAll(risen, j -> risen[j] - start);
            double[] rising = excitation.fineSeries(Spectra.timesJOmega(excitation.omega(), by));
            Spectra.add(risen, height[link], 1);
            Spectra.add(rising, rate[link], 1);
            height[link] = risen;
            rate[link] = rising;
        }

        /** Laws of the link of one, in their order. */
        private int[] sameLink(int law) {
            List<LawAt> laws = assembly.laws();
            return IntStream.range(0, laws.size()).filter(i -> laws.get(i).link() == laws.get(law).link()).toArray();
        }

        private static double[] sum(double[][][] slopes, int[] laws, int parameter) {
            double[] out = slopes[laws[0]][parameter];
            for (int l = 1; l < laws.length; l++) {
                Spectra.add(out, slopes[laws[l]][parameter], 1);
            }
            return out;
        }

        private FreeRun freeRun(Sensitivities slopes, double[][] modulation) {
            FreeRun run = excitation.isForced() ? FreeRun.inParts(structure, assembly.laws(), excitation.fineStep(), slopes, modulation)
                    : new FreeRun(structure, assembly.laws(), excitation.fineStep(), slopes, modulation);
            return run.leaping(excitation::later);
        }

        /** Link and body forces of the drives as force series on the bodies, at the free run's rate. */
        private double[][] bodySeries(double[][] forces, int parameter) {
            double[][] body = new double[structure.bodies()][2 * excitation.omega().length];
            for (int d = 0; d < forces.length; d++) {
                if (forces[d].length == 0) {
                    continue;
                }
                Assembly.DriveAt at = assembly.drives().get(d);
                if (at.drive().actsOnBody()) {
                    Spectra.add(body[at.place()], forces[d], 1);
                } else {
                    Row row = structure.stretch(at.place());
                    for (int i = 0; i < row.at().length; i++) {
                        Spectra.add(body[row.at()[i]], forces[d], -row.by()[i]);
                    }
                }
            }
            if (parameter < 0) {
                excitation.pushes().forEach((at, force) -> Spectra.add(body[at], force, 1));
            }
            double[][] series = java.util.Arrays.stream(body).map(excitation::held).toArray(double[][]::new);
            for (int d = 0; d < forces.length; d++) {
                stand(d, parameter, series);
                // Straight from its first sample to nothing at the next, a force is a blow of half a step times its size.
                if (assembly.drives().get(d).drive() instanceof Drive.Launch) {
                    series[assembly.drives().get(d).place()][0] += 2 / excitation.fineStep() * launch(d, parameter);
                }
            }
            return series;
        }

        /**
         * Lets a link that is lifted stand, at the start, on its lower end where that is then.
         *
         * @param parameter to which series are derivatives; -1: themselves
         * @param series by body. Modified.
         */
        private void stand(int d, int parameter, double[][] series) {
            int link = assembly.drives().get(d).place();
            double[] by = parameter == assembly.driveIndex(d) ? drives.liftSlope(d, parameter)
                    : parameter < 0 || parameter == link ? drives.lift(d) : new double[0];
            if (by.length > 0) {
                double carried = (parameter == link ? 1 : structure.stiffness()[link]) * excitation.fineSeries(by)[0];
                Row row = structure.stretch(link);
                for (int i = 0; i < row.at().length; i++) {
                    double[] pulled = series[row.at()[i]];
                    double force = -row.by()[i] * carried;
                    java.util.Arrays.setAll(pulled, j -> pulled[j] + force);
                }
            }
        }

        /**
         * Momentum that a drive gives its body at the start [N s], or its derivative to a parameter (-1: itself); 0 for all other drives.
         */
        private double launch(int d, int parameter) {
            Assembly.DriveAt at = assembly.drives().get(d);
            if (!(at.drive() instanceof Drive.Launch launch)) {
                return 0;
            }
            double mass = structure.mass()[at.place()];
            int ofMass = 2 * structure.links() + structure.kinematics().massOf()[at.place()];
            return parameter < 0 ? mass * launch.velocity() : parameter == ofMass ? launch.velocity()
                    : parameter == assembly.driveIndex(d) ? mass : 0;
        }

        /** Derivative of the motion of all bodies to a parameter: what the parameter's own force does. */
        private double[][] motionSlope(int p) {
            double[][] out = new double[structure.bodies()][2 * excitation.omega().length];
            int links = structure.links();
            if (p < links) {
                response.addLinkForce(p, response.stretch(p, q), out);
            } else if (p < 2 * links) {
                response.addLinkForce(p - links, Spectra.timesJOmega(excitation.omega(), response.stretch(p - links, q)), out);
            } else if (p < structure.parameters()) {
                for (int body : structure.sharing(p - 2 * links)) {
                    response.addBodyForce(body, acceleration(Row.of(body), q, 1), -1, out);
                }
            }
            for (int d = 0; d < driveForce.length; d++) {
                double[] slope = drives.slope(d, p);
                if (slope.length > 0) {
                    addDrive(d, slope, out);
                }
                if (assembly.drives().get(d).drive() instanceof Drive.Launch && p == assembly.driveIndex(d)) {
                    response.addLaunch(assembly.drives().get(d).place(), 1, out);
                }
            }
            for (int i = 0; i < lawForce.length; i++) {
                int link = assembly.laws().get(i).link();
                double[] slope = linear ? linearLawSlope(i, p) : lawSlope[p][i];
                if (slope.length > 0) {
                    response.addLinkForce(link, slope, out);
                }
            }
            return out;
        }

        /** Derivative of a linear law's force at unchanged motion; empty where there is none. */
        private double[] linearLawSlope(int i, int p) {
            int own = p - assembly.lawIndex(i);
            Record law = (Record) assembly.laws().get(i).law();
            double[] values = Numbers.values(law);
            if (own < 0 || own >= values.length) {
                return new double[0];
            }
            double h = 1e-5 * Math.max(Math.abs(values[own]), 1e-3);
            values[own] += h;
            double[] high = dynamicStiffness((Law) Numbers.with(law, values));
            values[own] -= 2 * h;
            double[] low = dynamicStiffness((Law) Numbers.with(law, values));
            for (int k = 0; k < high.length; k++) {
                high[k] = (high[k] - low[k]) / (2 * h);
            }
            return Spectra.product(high, deflection(assembly.laws().get(i).link()));
        }

        /** Reading of an output, or of its derivative to parameter p (-1: the reading itself), as a new spectrum. */
        private double[] read(Assembly.Output output, double[][] motion, int p) {
            if (output.reading() == Assembly.Reading.LINK_FORCE) {
                return linkForce(output.place(), motion, p);
            }
            double base = p < 0 ? 1 : 0;
            if (output.reading() == Assembly.Reading.ACCELERATION) {
                return acceleration(output.reads(), motion, base);
            }
            // The body's own motion directly, so that what a steady force does is not lost.
            boolean velocity = output.reading() == Assembly.Reading.VELOCITY;
            double[] omega = excitation.omega();
            double[] own = output.reads().of(motion, 2 * omega.length);
            double[] out = velocity ? Spectra.timesJOmega(omega, own) : own;
            double[] moved = Spectra.overJOmega(omega, carrying(output.reads(), base, excitation::base));
            Spectra.add(out, velocity ? moved : Spectra.overJOmega(omega, moved), 1);
            if (!velocity) {
                Spectra.add(out, carrying(output.reads(), base, excitation::track), 1);
            }
            return out;
        }

        /** Everything that the link carries: k r + c v, laws and drives. */
        private double[] linkForce(int link, double[][] motion, int p) {
            double[] out = Spectra.product(response.stiffness(link), response.stretch(link, motion));
            int links = structure.links();
            if (p == link) {
                Spectra.add(out, response.stretch(link, q), 1);
            } else if (p == links + link) {
                Spectra.add(out, Spectra.timesJOmega(excitation.omega(), response.stretch(link, q)), 1);
            }
            for (int i = 0; i < lawForce.length; i++) {
                if (assembly.laws().get(i).link() == link) {
                    double[] own = linear ? (p < 0 ? new double[0] : linearLawSlope(i, p)) : (p < 0 ? lawForce[i] : lawSlope[p][i]);
                    Spectra.add(out, own, 1);
                }
            }
            for (int d = 0; d < driveForce.length; d++) {
                Assembly.DriveAt at = assembly.drives().get(d);
                if (at.place() == link && !(at.drive().actsOnBody())) {
                    Spectra.add(out, p < 0 ? driveForce[d] : drives.slope(d, p), 1);
                }
            }
            return out;
        }

        /** A part of the base's acceleration as it carries the sum of some motions; along its first axis what nothing else moves. */
        private double[] carrying(Row reads, double base, IntFunction<double[]> moved) {
            double[] out = new double[2 * excitation.omega().length];
            for (int axis = 0; axis < structure.axes() && base != 0; axis++) {
                double part = reads.at().length == 0 && axis == 0 ? 1 : structure.kinematics().carried(reads, axis);
                Spectra.add(out, moved.apply(axis), base * part);
            }
            return out;
        }

        /** base · A - ω² q, summed over the motions that are read. */
        private double[] acceleration(Row reads, double[][] motion, double base) {
            double[] omega = excitation.omega();
            double[] out = carrying(reads, base, excitation::base);
            for (int i = 0; i < reads.at().length; i++) {
                double[] own = motion[reads.at()[i]];
                double factor = reads.by()[i];
                for (int k = 0; k < omega.length; k++) {
                    double w2 = k == 0 && response.isFree() ? 0 : factor * omega[k] * omega[k];   // what repeats has no mean acceleration
                    out[2 * k] -= w2 * own[2 * k];
                    out[2 * k + 1] -= w2 * own[2 * k + 1];
                }
            }
            return out;
        }
    }
}

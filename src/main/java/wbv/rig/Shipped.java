package wbv.rig;

import java.util.Locale;

/** The recordings that come with wbv, in {@code data/arff}; each is written by {@link RigFiles} from its spec. */
public enum Shipped {
    /** One mass, one spring, nothing changes. */
    ONE_DOF_LINEAR("sitter=one-dof zeta=0.35 f0=5 excitation=random:z:0.5-12:1 seconds=120 seed=1", true),
    /** The spring stiffens by a quarter after a minute. */
    ONE_DOF_STEP("sitter=one-dof zeta=0.35 f0=4.5 step=1.25@60 excitation=random:z:0.5-12:1 seconds=120 seed=2", true),
    /** Torso and head in series. */
    TWO_DOF("sitter=two-dof excitation=random:z:0.5-12:1 seconds=120 seed=3", true),
    /** The sweep of the thesis' chapter 4, frequency and amplitude together, on a person who softens; vertical sensors. */
    SWEEP_CHAPTER4("subject=2 excitation=sweep:z:1-9:0.1-2.5:60@60 seed=4 "
            + "channels=platform.acc.z,seat.acc.z,pelvis.acc.z,sternum.acc.z,head.acc.x,head.acc.z,head.gyr.y", true),
    /** Ten sensors on a person and the force under him: rest, gentle, harder, then with pitch; packets are lost. The README's. */
    RIDE_SUBJECT1("subject=1 excitation=idle@5+regime:8@45+regime:1@50+regime:7@50 seed=5 effects=usual,loss "
            + "channels=all,seat.force.z", false),
    /** What states of motion are learned from: rests, rides with jolts, rocking, at four regimes; seat and head. */
    STATES_TRAIN("subject=1 excitation=ride:1@60+ride:4@60+ride:6@60+ride:8@60 seed=6 "
            + "channels=platform.acc.z,seat.acc.z,seat.gyr.x,seat.gyr.y,head.acc.z", false),
    /** The same at the other four, on a person without a cushion. */
    STATES_BARE("subject=2 excitation=ride:2@60+ride:3@60+ride:5@60+ride:7@60 seed=8 effects=usual,-cushion "
            + "channels=platform.acc.z,seat.acc.z,seat.gyr.x,seat.gyr.y,head.acc.z", false),
    /** Two of them on a third person, to try what was learned. */
    STATES_OTHER("subject=3 excitation=ride:1@60+ride:7@60 seed=7 "
            + "channels=platform.acc.z,seat.acc.z,seat.gyr.x,seat.gyr.y,head.acc.z", false);

    private final String spec;
    private final boolean full;

    Shipped(String spec, boolean full) {
        this.spec = spec;
        this.full = full;
    }

    /** The file's name without folder, such as {@code one-dof-linear.arff}. */
    public String fileName() {
        return name().toLowerCase(Locale.ROOT).replace('_', '-') + ".arff";
    }

    /** What it was made from. */
    public RigSpec spec() {
        return RigSpec.parse(spec);
    }

    /** Whether states and ideal outputs stand in its truth, not the parameters alone. */
    public boolean full() {
        return full;
    }
}

package wbv.network;

import ai.djl.ndarray.NDList;
import ai.djl.ndarray.types.Shape;
import ai.djl.nn.Activation;
import ai.djl.nn.Block;
import ai.djl.nn.Blocks;
import ai.djl.nn.Parameter;
import ai.djl.nn.ParallelBlock;
import ai.djl.nn.SequentialBlock;
import ai.djl.nn.convolutional.Conv2d;
import ai.djl.nn.core.Linear;
import ai.djl.nn.norm.BatchNorm;
import ai.djl.nn.norm.Dropout;
import ai.djl.nn.pooling.Pool;
import ai.djl.training.initializer.XavierInitializer;
import java.util.List;

/** The networks' layers. */
final class Layers {

    /** Units of the thesis' convolutions. */
    private static final int UNITS = 48;
    /** Rows, and columns, of the last map: a quarter of an image's. */
    private static final int LAST_MAP = Imaging.BINS / 4;
    private static final int POOLED = 24;
    private static final int GATED = 16;
    private static final int DENSE = 64;

    private Layers() {}

    /**
     * A network without weights.
     *
     * @param outputs means, followed by logarithms of variances if the architecture is uncertain
     */
    static Block of(Architecture architecture, int outputs, double dropout) {
        SequentialBlock net = switch (architecture) {
            case CNN -> ended(cnn(), dropout);
            case RESIDUAL -> ended(residual(), dropout);
            case THESIS_CNN -> ended(averaged(cnn()), dropout);
            case THESIS_RESIDUAL -> ended(averaged(residual()), dropout);
            case POOLED, ANSWER_ONLY, THREE_AXES -> pooled(dropout);
        };
        net.add(Linear.builder().setUnits(outputs).build());
        // He et al. 2015: keeps the variance through layers of ReLU.
        net.setInitializer(new XavierInitializer(XavierInitializer.RandomType.GAUSSIAN, XavierInitializer.FactorType.IN, 2),
                Parameter.Type.WEIGHT);
        return net;
    }

    private static SequentialBlock cnn() {
        SequentialBlock net = new SequentialBlock();
        for (int i = 0; i < 3; i++) {
            net.add(convolution(UNITS, 3, 3, 1)).add(BatchNorm.builder().build()).add(Activation.reluBlock());
            if (i < 2) {
                net.add(Pool.avgPool2dBlock(new Shape(2, 2), new Shape(2, 2)));
            }
        }
        return net;
    }

    private static SequentialBlock ended(SequentialBlock net, double dropout) {
        return net.add(Dropout.builder().optRate((float) dropout).build()).add(Blocks.batchFlattenBlock());
    }

    /**
     * The mean over the last map (He et al. 2016). How the thesis' networks end is not printed, but its learning rate, 0.005, is: with
     * 3 072 unpooled features under the regression that rate diverges within an epoch, with their 48 means it does not.
     */
    private static SequentialBlock averaged(SequentialBlock net) {
        return net.add(Pool.avgPool2dBlock(new Shape(LAST_MAP, LAST_MAP), new Shape(LAST_MAP, LAST_MAP)));
    }

    private static SequentialBlock residual() {
        return new SequentialBlock().add(convolution(UNITS, 3, 3, 1)).add(BatchNorm.builder().build())
                .add(Activation.reluBlock()).add(unit(2)).add(unit(2)).add(unit(1));
    }

    /** Two convolutions and the way past them (He et al. 2016). */
    private static SequentialBlock unit(int stride) {
        SequentialBlock through = new SequentialBlock().add(convolution(UNITS, 3, 3, stride)).add(BatchNorm.builder().build())
                .add(Activation.reluBlock()).add(convolution(UNITS, 3, 3, 1)).add(BatchNorm.builder().build());
        SequentialBlock past = new SequentialBlock();
        if (stride == 1) {
            past.add(Blocks.identityBlock());
        } else {
            past.add(convolution(UNITS, 1, 1, stride)).add(BatchNorm.builder().build());
        }
        return new SequentialBlock().add(new ParallelBlock(
                both -> new NDList(both.get(0).singletonOrThrow().add(both.get(1).singletonOrThrow())),
                List.of(through, past))).add(Activation.reluBlock());
    }

    private static SequentialBlock pooled(double dropout) {
        return new SequentialBlock().add(convolution(POOLED, 1, 1,
                1)).add(BatchNorm.builder().build()).add(Activation.reluBlock())
                .add(convolution(POOLED, 3, 1, 1)).add(BatchNorm.builder().build()).add(Activation.reluBlock())
                .add(new TimePooling(GATED)).add(Blocks.batchFlattenBlock())
                .add(Linear.builder().setUnits(DENSE).build()).add(Activation.reluBlock())
                .add(Dropout.builder().optRate((float) dropout).build());
    }

    private static Conv2d convolution(int units, int high, int wide, int stride) {
        return Conv2d.builder().setKernelShape(new Shape(high, wide)).optPadding(new Shape(high / 2, wide / 2))
                .optStride(new Shape(stride, stride)).setFilters(units).build();
    }
}

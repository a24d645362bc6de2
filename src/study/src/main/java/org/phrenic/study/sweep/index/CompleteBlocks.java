package org.phrenic.study.sweep.index;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.DoubleStream;

/** The blocks of a design whose runs all succeeded. */
final class CompleteBlocks {
    private CompleteBlocks() {}

    /** Blocks of {@code size} consecutive responses that are all finite. */
    static List<double[]> of(double[] responses, int size) {
        List<double[]> blocks = new ArrayList<>();
        for (int from = 0; from + size <= responses.length; from += size) {
            double[] block = Arrays.copyOfRange(responses, from, from + size);
            if (DoubleStream.of(block).allMatch(Double::isFinite)) {
                blocks.add(block);
            }
        }
        return blocks;
    }
}

package org.phrenic.scene.export;

import java.awt.image.BufferedImage;
import java.awt.image.IndexColorModel;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/**
 * The 256 colours that show a picture best, by median cut (Heckbert 1982, doi 10.1145/965145.801294): the box of
 * colours with the widest spread, weighted by its pixels, is halved at its median until there are enough. Colours are
 * told apart to 6 bits a channel; what lies between two is dithered by a fixed pattern, which stands still from frame
 * to frame.
 */
final class GifPalette {
    private static final int COLOURS = 256;
    private static final int BITS = 6;
    private static final int LEVELS = 1 << BITS;
    private static final int CELLS = LEVELS * LEVELS * LEVELS;

    /** Thresholds of an ordered dither, 0 to 15 (Bayer 1973). */
    private static final int[] BAYER = {0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5};

    /** How far a dither moves a channel, of 255: about half the distance between colours of a palette. */
    private static final int DITHER = 6;

    private final int[] cells;
    private final int[] weights;
    private final byte[][] table = new byte[3][COLOURS];
    private final byte[] nearestEntry = new byte[CELLS];
    private final boolean[] nearestKnown = new boolean[CELLS];
    private int size;

    /** Part of the cells that becomes one colour. */
    private record Box(int from, int to, int axis, double spread) {}

    private GifPalette(int[] cells, int[] weights) {
        this.cells = cells;
        this.weights = weights;
    }

    /** The picture in 256 colours of its own. */
    static BufferedImage quantized(BufferedImage picture) {
        BufferedImage rgb = PngFile.flattened(picture);
        int[] counts = new int[CELLS];
        int width = rgb.getWidth();
        int[] row = new int[width];
        for (int y = 0; y < rgb.getHeight(); y++) {
            for (int pixel : rgb.getRGB(0, y, width, 1, row, 0, width)) {
                counts[cell(pixel >> 16 & 0xff, pixel >> 8 & 0xff, pixel & 0xff)]++;
            }
        }
        List<Integer> used = new ArrayList<>();
        for (int i = 0; i < CELLS; i++) {
            if (counts[i] > 0) {
                used.add(i);
            }
        }
        GifPalette palette =
                new GifPalette(used.stream().mapToInt(Integer::intValue).toArray(), counts);
        palette.medianCut();
        return palette.dithered(rgb);
    }

    private static int cell(int red, int green, int blue) {
        int drop = 8 - BITS;
        return ((red >> drop) << (2 * BITS)) | ((green >> drop) << BITS) | (blue >> drop);
    }

    private static int channel(int cell, int axis) {
        return (cell >> ((2 - axis) * BITS)) & (LEVELS - 1);
    }

    private void medianCut() {
        List<Box> boxes = new ArrayList<>();
        boxes.add(box(0, cells.length));
        while (boxes.size() < COLOURS) {
            Box widest =
                    boxes.stream().max(Comparator.comparingDouble(Box::spread)).orElseThrow();
            if (widest.spread <= 0) {
                break;
            }
            boxes.remove(widest);
            int middle = splitAtMedian(widest);
            boxes.add(box(widest.from, middle));
            boxes.add(box(middle, widest.to));
        }
        for (Box box : boxes) {
            addMean(box);
        }
    }

    /** The axis along which the cells of a box differ most, and how much they do: the sum of squares about the mean. */
    private Box box(int from, int to) {
        int axis = 0;
        double spread = -1;
        for (int k = 0; k < 3; k++) {
            double n = 0;
            double sum = 0;
            double squares = 0;
            for (int i = from; i < to; i++) {
                // A small thing of its own colour counts too: the square root keeps backgrounds from taking all
                // colours.
                double weight = Math.sqrt(weights[cells[i]]);
                double value = channel(cells[i], k);
                n += weight;
                sum += weight * value;
                squares += weight * value * value;
            }
            double about = to - from > 1 ? squares - sum * sum / n : 0;
            if (about > spread) {
                spread = about;
                axis = k;
            }
        }
        return new Box(from, to, axis, to - from > 1 ? Math.max(spread, 1e-6) : 0);
    }

    private int splitAtMedian(Box box) {
        int[] sorted = java.util.Arrays.stream(cells, box.from, box.to)
                .boxed()
                .sorted(Comparator.comparingInt((Integer c) -> channel(c, box.axis)))
                .mapToInt(Integer::intValue)
                .toArray();
        System.arraycopy(sorted, 0, cells, box.from, sorted.length);
        double half = java.util.Arrays.stream(sorted)
                        .mapToDouble(c -> Math.sqrt(weights[c]))
                        .sum()
                / 2;
        double sum = 0;
        for (int i = 0; i < sorted.length - 1; i++) {
            sum += Math.sqrt(weights[sorted[i]]);
            if (sum >= half) {
                return box.from + i + 1;
            }
        }
        return box.to - 1;
    }

    private void addMean(Box box) {
        double n = 0;
        double[] sums = new double[3];
        for (int i = box.from; i < box.to; i++) {
            double weight = weights[cells[i]];
            n += weight;
            for (int k = 0; k < 3; k++) {
                sums[k] += weight * channel(cells[i], k);
            }
        }
        for (int k = 0; k < 3; k++) {
            // Cells of 6 bits span 0 to 63; stretched so that black stays black and white white.
            table[k][size] = (byte) Math.round(sums[k] / n * 255 / (LEVELS - 1));
        }
        size++;
    }

    private BufferedImage dithered(BufferedImage rgb) {
        int width = rgb.getWidth();
        int height = rgb.getHeight();
        IndexColorModel model = new IndexColorModel(8, COLOURS, table[0], table[1], table[2]);
        BufferedImage reduced = new BufferedImage(width, height, BufferedImage.TYPE_BYTE_INDEXED, model);
        int[] row = new int[width];
        byte[] indices = new byte[width];
        for (int y = 0; y < height; y++) {
            rgb.getRGB(0, y, width, 1, row, 0, width);
            for (int x = 0; x < width; x++) {
                int shift = (2 * BAYER[(y & 3) * 4 + (x & 3)] - 15) * DITHER / 30;
                indices[x] = nearestIndex(
                        cell(shifted(row[x] >> 16, shift), shifted(row[x] >> 8, shift), shifted(row[x], shift)));
            }
            reduced.getRaster().setDataElements(0, y, width, 1, indices);
        }
        return reduced;
    }

    private static int shifted(int channel, int shift) {
        return Math.max(0, Math.min(255, (channel & 0xff) + shift));
    }

    private byte nearestIndex(int cell) {
        if (!nearestKnown[cell]) {
            int best = 0;
            int least = Integer.MAX_VALUE;
            for (int i = 0; i < size; i++) {
                int distance = 0;
                for (int k = 0; k < 3; k++) {
                    int d = (table[k][i] & 0xff) - channel(cell, k) * 255 / (LEVELS - 1);
                    distance += d * d;
                }
                if (distance < least) {
                    least = distance;
                    best = i;
                }
            }
            nearestEntry[cell] = (byte) best;
            nearestKnown[cell] = true;
        }
        return nearestEntry[cell];
    }
}

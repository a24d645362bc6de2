package org.phrenic.access.ultrasound;

/**
 * The point spread of a probe in the image plane: Gaussians along the scan lines and across them, whose width grows
 * with the depth ({@link CurvilinearProbe}). Scatterers add up as complex numbers; their kernels keep the mean power of
 * the noise of {@link SpeckleField}. Echoes of interfaces add up as amplitudes; their kernels have sum 1, so that an
 * interface along the lines' ends keeps its amplitude. Beyond the outermost lines the image is mirrored.
 */
final class PointSpread {
    private static final double REACH_SIGMAS = 2.5;

    private final int lines = SectorGrid.LINES;
    private final int samples = SectorGrid.SAMPLES;
    private final float[] axial;
    /** Factor of a line so many lines away, by sample; the same on both sides. */
    private final float[][] noise;

    private final float[][] echo;
    private final float[] real = new float[lines * samples];
    private final float[] imaginary = new float[lines * samples];

    PointSpread(SectorGrid grid) {
        double sigma = grid.probe.axialWidthMm() / EchoField.WIDTH_PER_SIGMA;
        axial = normalized(gaussian(sigma, grid.stepMm), grid.stepMm, true);
        float[][][] kernels = new float[2][samples][];
        int reach = 0;
        for (int s = 0; s < samples; s++) {
            double depth = s * grid.stepMm;
            double spacing = grid.lineSpacingMm(depth);
            double[] g = gaussian(grid.probe.lateralWidthMm(depth) / EchoField.WIDTH_PER_SIGMA, spacing);
            kernels[0][s] = normalized(g, spacing, true);
            kernels[1][s] = normalized(g, spacing, false);
            reach = Math.max(reach, g.length - 1);
        }
        noise = bySample(kernels[0], reach);
        echo = bySample(kernels[1], reach);
    }

    private static double[] gaussian(double sigma, double spacing) {
        double[] g = new double[1 + (int) Math.ceil(REACH_SIGMAS * sigma / spacing)];
        for (int i = 0; i < g.length; i++) {
            double x = i * spacing / sigma;
            g[i] = StrictMath.exp(-0.5 * x * x);
        }
        return g;
    }

    /**
     * One half of a symmetric kernel.
     *
     * @param noise whether the kernel keeps the power of the speckle's noise; else it has sum 1
     */
    private static float[] normalized(double[] half, double spacing, boolean noise) {
        double sum = 0;
        for (int i = 1 - half.length; i < half.length; i++) {
            if (noise) {
                for (int k = 1 - half.length; k < half.length; k++) {
                    sum += half[Math.abs(i)] * half[Math.abs(k)] * SpeckleField.correlation((i - k) * spacing);
                }
            } else {
                sum += half[Math.abs(i)];
            }
        }
        double scale = noise ? 1 / Math.sqrt(sum) : 1 / sum;
        float[] kernel = new float[half.length];
        for (int i = 0; i < kernel.length; i++) {
            kernel[i] = (float) (half[i] * scale);
        }
        return kernel;
    }

    private static float[][] bySample(float[][] kernels, int reach) {
        float[][] out = new float[reach + 1][kernels.length];
        for (int s = 0; s < kernels.length; s++) {
            for (int k = 0; k < kernels[s].length; k++) {
                out[k][s] = kernels[s][k];
            }
        }
        return out;
    }

    /** Writes the intensity of each sample of the blurred field, line by line. */
    void apply(EchoField field, float[] intensity, int threads) {
        Bands.run(lines, threads, (from, to) -> {
            for (int line = from; line < to; line++) {
                alongLine(field.real, real, line);
                alongLine(field.imaginary, imaginary, line);
            }
        });
        Bands.run(lines, threads, (from, to) -> {
            float[][] sums = new float[3][samples];
            for (int line = from; line < to; line++) {
                acrossLines(real, noise, line, sums[0]);
                acrossLines(imaginary, noise, line, sums[1]);
                acrossLines(field.interfaces, echo, line, sums[2]);
                for (int s = 0; s < samples; s++) {
                    intensity[line * samples + s] =
                            sums[0][s] * sums[0][s] + sums[1][s] * sums[1][s] + sums[2][s] * sums[2][s];
                }
            }
        });
    }

    private void alongLine(float[] in, float[] out, int line) {
        int row = line * samples;
        for (int s = 0; s < samples; s++) {
            out[row + s] = axial[0] * in[row + s];
        }
        for (int k = 1; k < axial.length; k++) {
            float w = axial[k];
            for (int s = k; s < samples; s++) {
                out[row + s] += w * in[row + s - k];
            }
            for (int s = 0; s < samples - k; s++) {
                out[row + s] += w * in[row + s + k];
            }
        }
    }

    private void acrossLines(float[] in, float[][] kernel, int line, float[] out) {
        int row = line * samples;
        for (int s = 0; s < samples; s++) {
            out[s] = kernel[0][s] * in[row + s];
        }
        for (int k = 1; k < kernel.length; k++) {
            int before = Math.abs(line - k) * samples;
            int last = lines - 1;
            int after = (last - Math.abs(last - line - k)) * samples;
            float[] w = kernel[k];
            for (int s = 0; s < samples; s++) {
                out[s] += w[s] * (in[before + s] + in[after + s]);
            }
        }
    }
}

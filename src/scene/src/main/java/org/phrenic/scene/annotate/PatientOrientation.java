package org.phrenic.scene.annotate;

import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.joml.Vector3d;

/** Letters of an anatomical direction: L left, R right, A anterior, P posterior, S superior, I inferior. */
public final class PatientOrientation {
    /** Minimum absolute component of a unit vector for its letter: the sine of 22.5 degrees. */
    private static final double THRESHOLD = 0.3827;

    private PatientOrientation() {}

    /** Letters of a unit vector in LPS, largest component first: {@code S}, {@code LA}. */
    public static String letters(Vector3d direction) {
        return IntStream.range(0, 3)
                .boxed()
                .filter(i -> Math.abs(direction.get(i)) >= THRESHOLD)
                .sorted((i, j) -> Double.compare(Math.abs(direction.get(j)), Math.abs(direction.get(i))))
                .map(i -> (direction.get(i) > 0 ? "LPS" : "RAI").substring(i, i + 1))
                .collect(Collectors.joining());
    }

    /** Letters of the opposite direction: {@code I} of {@code S}, {@code RP} of {@code LA}. */
    public static String opposite(String letters) {
        String from = "LRAPSI";
        String to = "RLPAIS";
        return letters.chars()
                .mapToObj(c -> String.valueOf(to.charAt(from.indexOf(c))))
                .collect(Collectors.joining());
    }
}

package org.phrenic.study.sweep;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.apache.commons.math3.distribution.NormalDistribution;
import org.phrenic.document.Key;
import org.phrenic.document.ShippedFile;
import org.phrenic.study.body.BodyVariation;

/**
 * Statistics of adults, from which persons are drawn, and their bodies: size and shape relative to the virtual body of
 * their sex. With h the stature and b the body mass index, both relative to the virtual body's: the height scales with
 * h, breadth and depth with h and a power of b, the domes rise with the logarithm of b, and the spine bends with age.
 *
 * @param ageYears least and greatest age
 * @param kyphosisDegPerYear further bend of the spine a year after the age of the virtual body
 * @param sexes statistics by sex
 * @param breadthExponent of b for the breadth
 * @param depthExponent of b for the depth
 * @param barrelPerLog deepening of the chest by the logarithm of b
 * @param domeLiftMmPerLog rise of the domes by the logarithm of b, mm
 */
record Cohort(
        @Key(count = 2) double[] ageYears,
        double kyphosisDegPerYear,
        List<Sex> sexes,
        double breadthExponent,
        double depthExponent,
        double barrelPerLog,
        double domeLiftMmPerLog) {
    private static final double MM_PER_M = 1000;
    /** Statures and body mass indices beyond this quantile on either side are not drawn. */
    private static final double TAIL = 0.005;

    /**
     * Statistics of one sex.
     *
     * @param sex {@code male} or {@code female}
     * @param body the virtual body
     * @param heightMm mean and standard deviation of the stature, mm
     * @param massIndex median of the body mass index, kg/m^2, and standard deviation of its logarithm
     * @param virtual age, years, stature, mm, and weight, kg, of the virtual body
     */
    record Sex(
            String sex,
            String body,
            double share,
            @Key(count = 2) double[] heightMm,
            @Key(count = 2) double[] massIndex,
            @Key(value = "virtual", count = 3) double[] virtual) {
        double ageOfBody() {
            return virtual[0];
        }

        double heightOfBodyM() {
            return virtual[1] / MM_PER_M;
        }

        double massIndexOfBody() {
            return virtual[2] / (heightOfBodyM() * heightOfBodyM());
        }
    }

    /** The table that comes with the program. */
    static Cohort shipped() {
        return ShippedFile.yaml("cohort/adults.yaml").bind(Cohort.class);
    }

    /** Persons, always the same of one seed; a larger cohort begins with the smaller one. */
    List<Person> draw(int count, long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        NormalDistribution normal = new NormalDistribution(null, 0, 1);
        List<Person> persons = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            Sex sex = random.nextDouble() < sexes.get(0).share() ? sexes.get(0) : sexes.get(1);
            double age = ageYears[0] + random.nextDouble() * (ageYears[1] - ageYears[0]);
            double heightMm = sex.heightMm()[0] + sex.heightMm()[1] * deviate(normal, random);
            double index = sex.massIndex()[0] * StrictMath.exp(sex.massIndex()[1] * deviate(normal, random));
            double heightM = Math.rint(heightMm / 10) / 100;
            double weightKg = Math.rint(index * heightM * heightM * 10) / 10;
            persons.add(new Person(sex.sex(), (int) age, heightM, weightKg));
        }
        return persons;
    }

    private static double deviate(NormalDistribution normal, SplittableRandom random) {
        return normal.inverseCumulativeProbability(TAIL + (1 - 2 * TAIL) * random.nextDouble());
    }

    private Sex of(Person person) {
        return sexes.stream()
                .filter(s -> s.sex().equals(person.sex()))
                .findFirst()
                .orElseThrow();
    }

    /** The virtual body that becomes the person's. */
    String body(Person person) {
        return of(person).body();
    }

    /** Size and shape of a person's body relative to the virtual one, within what a body can be varied. */
    BodyVariation variation(Person person) {
        Sex sex = of(person);
        double h = person.heightM() / sex.heightOfBodyM();
        double b = person.massIndex() / sex.massIndexOfBody();
        double log = StrictMath.log(b);
        return new BodyVariation(
                scale(h * StrictMath.pow(b, breadthExponent)),
                scale(h * StrictMath.pow(b, depthExponent)),
                scale(h),
                within(kyphosisDegPerYear * (person.ageYears() - sex.ageOfBody()), 0, BodyVariation.MOST_KYPHOSIS_DEG),
                within(barrelPerLog * log, 0, BodyVariation.MOST_BARREL),
                within(domeLiftMmPerLog * log, BodyVariation.LOWEST_DOMES_MM, BodyVariation.HIGHEST_DOMES_MM));
    }

    private static double scale(double factor) {
        return within(factor, BodyVariation.LEAST_SCALE, BodyVariation.MOST_SCALE);
    }

    private static double within(double value, double least, double most) {
        return Math.max(least, Math.min(most, value));
    }
}

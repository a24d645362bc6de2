package org.phrenic.study.sweep;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.phrenic.document.Key;
import org.phrenic.study.BreathSeries;
import org.phrenic.study.validation.Reduction;

/**
 * A response of a simulated breath: a reduction of one or more observables to a number.
 *
 * @param name column of the table of runs; by default observable and reduction
 * @param observable column of {@code observables.csv} or an observable of {@code validate}
 * @param observables for {@link Reduction#ORDER}, in place of {@code observable}
 * @param reduction of the time series
 * @param against second observable, where the reduction needs one
 * @param share for {@link Reduction#AT_SHARE}
 * @param factor that converts the number to the unit of the response
 */
public record ResponseSpec(
        @Key(absent = "") String name,
        @Key(absent = "") String observable,
        @Key(absent = "") List<String> observables,
        Reduction reduction,
        @Key(absent = "") String against,
        @Key(absent = "1") double share,
        @Key(absent = "1") double factor) {
    /** @throws IllegalArgumentException with one sentence, if observables are missing or superfluous */
    public ResponseSpec {
        if (observable.isEmpty() == observables.isEmpty()) {
            throw new IllegalArgumentException("found " + (observable.isEmpty() ? "no observable" : "two statements")
                    + ", expected either observable or observables");
        }
        if (reduction.needsSecondObservable() == against.isEmpty()) {
            throw new IllegalArgumentException("found the reduction " + reduction.label()
                    + (against.isEmpty() ? " without a second observable, expected against" : " with against"));
        }
        if (reduction == Reduction.ORDER && observables.size() < 2) {
            throw new IllegalArgumentException("found one observable, expected at least two for order");
        }
        observables = observables.isEmpty() ? List.of(observable) : List.copyOf(observables);
        observable = "";
        name = name.isEmpty() ? String.join("_", observables) + "_" + reduction.label() : name;
    }

    /** @throws IllegalArgumentException with one sentence, if the reduction cannot read what is stated */
    void requireRead() {
        if (reduction != Reduction.ORDER && observables.size() > 1) {
            throw new IllegalArgumentException("found " + observables.size() + " observables with the reduction "
                    + reduction.label() + ", which reads one, expected a response for each");
        }
        if (reduction != Reduction.AT_SHARE && share != 1) {
            throw new IllegalArgumentException("found a share with the reduction " + reduction.label()
                    + ", which reads none, expected it with at_share");
        }
        if (!(share > 0 && share <= 1)) {
            throw new IllegalArgumentException("found the share " + share + ", expected more than 0 to 1");
        }
    }

    /** All observables that are needed. */
    List<String> needed() {
        List<String> all = new ArrayList<>(observables);
        if (!against.isEmpty()) {
            all.add(against);
        }
        return all;
    }

    /**
     * The response of a breath.
     *
     * @throws IllegalStateException with one sentence, if the breath has no such number
     */
    double valueIn(BreathSeries breath) {
        double value = factor * reduction.of(breath, breath, observables, against, share);
        if (!Double.isFinite(value)) {
            throw new IllegalStateException("response '" + name + "': found no number, " + whyAbsent(breath));
        }
        return value;
    }

    private String whyAbsent(BreathSeries breath) {
        if (needsHold() && !breath.hasHold()) {
            return "expected a breath with a hold";
        }
        return needed().stream()
                .filter(observable -> Double.isNaN(breath.value(observable, 0)))
                .findFirst()
                .map(observable -> "expected a body that has " + observable)
                .orElse("expected a breath that gives " + reduction.label() + " of " + String.join(", ", observables));
    }

    /** Whether only a breath with a hold has the response. */
    boolean needsHold() {
        return reduction == Reduction.CREEP;
    }

    /** The response as in a study file. */
    Map<String, Object> toMap() {
        Map<String, Object> map = new LinkedHashMap<>();
        map.put("name", name);
        map.put("observables", observables);
        map.put("reduction", reduction.label());
        if (!against.isEmpty()) {
            map.put("against", against);
        }
        map.put("share", share);
        map.put("factor", factor);
        return map;
    }
}

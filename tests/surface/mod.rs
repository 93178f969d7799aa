mod feet;
mod golden;
mod overlaps;
mod pairs;
mod round;
mod solids;
mod tangle;
mod topology;

/* Every category: one function that draws it, one row here that names it. */
#ifndef DMG_CATEGORIES_H
#define DMG_CATEGORIES_H

#include "build.h"

#define DMG_CATEGORIES(X)                                                                                              \
    /* storage.c */                                                                                                    \
    X(kitchen_cabinet)                                                                                                 \
    X(cabinet)                                                                                                         \
    X(drawers)                                                                                                         \
    /* furniture.c */                                                                                                  \
    X(table)                                                                                                           \
    X(wardrobe)                                                                                                        \
    X(folding_chair)                                                                                                   \
    X(swivel_chair)                                                                                                    \
    /* appliances.c */                                                                                                 \
    X(microwave)                                                                                                       \
    X(oven)                                                                                                            \
    X(toaster)                                                                                                         \
    X(coffee_machine)                                                                                                  \
    /* cold.c */                                                                                                       \
    X(refrigerator)                                                                                                    \
    X(dishwasher)                                                                                                      \
    X(washing_machine)                                                                                                 \
    X(safe)                                                                                                            \
    /* office.c */                                                                                                     \
    X(printer)                                                                                                         \
    X(camera)                                                                                                          \
    X(remote)                                                                                                          \
    X(keyboard)                                                                                                        \
    /* lids.c */                                                                                                       \
    X(chest)                                                                                                           \
    X(bucket)                                                                                                          \
    /* containers.c */                                                                                                 \
    X(trash_can)                                                                                                       \
    X(box)                                                                                                             \
    X(pot)                                                                                                             \
    X(toilet)                                                                                                          \
    X(suitcase)                                                                                                        \
    X(mailbox)                                                                                                         \
    /* slabs.c */                                                                                                      \
    X(laptop)                                                                                                          \
    X(phone)                                                                                                           \
    X(stapler)                                                                                                         \
    X(scissors)                                                                                                        \
    X(pliers)                                                                                                          \
    X(lighter)                                                                                                         \
    X(book)                                                                                                            \
    /* openings.c */                                                                                                   \
    X(door)                                                                                                            \
    X(sliding_window)                                                                                                  \
    X(window)                                                                                                          \
    X(gate)                                                                                                            \
    X(sliding_door)                                                                                                    \
    X(trapdoor)                                                                                                        \
    X(barrier)                                                                                                         \
    /* buildings.c */                                                                                                  \
    X(hangar_door)                                                                                                     \
    X(garage_door)                                                                                                     \
    X(drawbridge)                                                                                                      \
    /* controls.c */                                                                                                   \
    X(knob)                                                                                                            \
    X(faucet)                                                                                                          \
    X(button)                                                                                                          \
    /* levers.c */                                                                                                     \
    X(lever)                                                                                                           \
    X(switch)                                                                                                          \
    X(slider)                                                                                                          \
    X(crank)                                                                                                           \
    X(valve)                                                                                                           \
    X(joystick)                                                                                                        \
    X(game_controller)                                                                                                 \
    X(pedal)                                                                                                           \
    /* wheels.c */                                                                                                     \
    X(wheel)                                                                                                           \
    /* rotors.c */                                                                                                     \
    X(fan)                                                                                                             \
    X(propeller)                                                                                                       \
    X(wind_turbine)                                                                                                    \
    X(globe)                                                                                                           \
    X(clock)                                                                                                           \
    X(turntable)                                                                                                       \
    X(radar)                                                                                                           \
    /* handheld.c */                                                                                                   \
    X(motion_controller)                                                                                               \
    X(pistol)                                                                                                          \
    /* aircraft.c */                                                                                                   \
    X(aeroplane)                                                                                                       \
    X(helicopter)                                                                                                      \
    X(drone)                                                                                                           \
    X(windsock)                                                                                                        \
    /* robots.c */                                                                                                     \
    X(gripper)                                                                                                         \
    X(robot_arm)                                                                                                       \
    X(legged_robot)                                                                                                    \
    X(pan_tilt)                                                                                                        \
    X(rail)                                                                                                            \
    X(jetway)                                                                                                          \
    X(crane)                                                                                                           \
    /* cockpit.c */                                                                                                    \
    X(control_panel)                                                                                                   \
    X(instrument)                                                                                                      \
    X(yoke)                                                                                                            \
    X(throttle)                                                                                                        \
    /* gadget.c */                                                                                                     \
    X(gadget)                                                                                                          \
    /* vehicles.c */                                                                                                   \
    X(car)                                                                                                             \
    X(two_wheeler)                                                                                                     \
    X(mobile_robot)                                                                                                    \
    X(trolley)                                                                                                         \
    /* small.c */                                                                                                      \
    X(bottle)                                                                                                          \
    X(jar)                                                                                                             \
    X(dispenser)                                                                                                       \
    X(syringe)                                                                                                         \
    X(pen)                                                                                                             \
    X(usb_stick)                                                                                                       \
    X(folding_knife)                                                                                                   \
    X(eyeglasses)                                                                                                      \
    X(padlock)                                                                                                         \
    /* household.c */                                                                                                  \
    X(desk_lamp)                                                                                                       \
    X(kettle)                                                                                                          \
    X(latch)                                                                                                           \
    X(folding_panel)                                                                                                   \
    X(kitchen_counter)                                                                                                 \
    X(step_ladder)                                                                                                     \
    X(swing)                                                                                                           \
    X(vise)                                                                                                            \
    /* machines.c */                                                                                                   \
    X(roll_top)                                                                                                        \
    X(pivot_panel)                                                                                                     \
    X(telescope)                                                                                                       \
    X(gyroscope)                                                                                                       \
    X(turnstile)                                                                                                       \
    X(vending_machine)                                                                                                 \
    X(figure)                                                                                                          \
    X(gear_train)                                                                                                      \
    X(fairground_wheel)                                                                                                \
    X(mixer)                                                                                                           \
    X(power_tool)                                                                                                      \
    X(press)                                                                                                           \
    X(balance)                                                                                                         \
    X(slats)                                                                                                           \
    /* notebooks.c */                                                                                                  \
    X(notebook)                                                                                                        \
    /* hutches.c */                                                                                                    \
    X(slab_cabinet)                                                                                                    \
    X(sliding_cabinet)                                                                                                 \
    X(desk_hutch)                                                                                                      \
    X(nightstand)                                                                                                      \
    X(showcase)                                                                                                        \
    /* strongboxes.c */                                                                                                \
    X(strongbox)                                                                                                       \
    X(counter_oven)                                                                                                    \
    X(cooler)                                                                                                          \
    /* openings.c */                                                                                                   \
    X(post_door)                                                                                                       \
    /* cases.c */                                                                                                      \
    X(hard_case)                                                                                                       \
    X(pail)                                                                                                            \
    X(lidded_bin)                                                                                                      \
    X(flag_box)                                                                                                        \
    /* toolboxes.c */                                                                                                  \
    X(toolbox)                                                                                                         \
    X(casement)                                                                                                        \
    /* aircraft.c */                                                                                                   \
    X(submarine)                                                                                                       \
    /* jet.c */                                                                                                        \
    X(jet)                                                                                                             \
    /* chassis.c */                                                                                                    \
    X(chassis)                                                                                                         \
    X(wheelchair)                                                                                                      \
    /* cockpit.c */                                                                                                    \
    X(avionics)                                                                                                        \
    X(switchboard)                                                                                                     \
    /* gauges.c */                                                                                                     \
    X(gauge)                                                                                                           \
    /* controllers.c */                                                                                                \
    X(vr_controller)                                                                                                   \
    X(gamepad)                                                                                                         \
    /* solar.c */                                                                                                      \
    X(satellite)                                                                                                       \
    X(solar_case)                                                                                                      \
    X(solar_tracker)                                                                                                   \
    /* dishes.c */                                                                                                     \
    X(dish)                                                                                                            \
    X(radar_tower)                                                                                                     \
    /* linkages.c */                                                                                                   \
    X(claw)                                                                                                            \
    X(bar_legs)                                                                                                        \
    X(humanoid)                                                                                                        \
    X(bracket)                                                                                                         \
    /* taps.c */                                                                                                       \
    X(tap)                                                                                                             \
    /* stoves.c */                                                                                                     \
    X(stove)                                                                                                           \
    /* lever_stands.c */                                                                                               \
    X(lever_stand)                                                                                                     \
    /* shelter.c */                                                                                                    \
    X(shelter)                                                                                                         \
    /* bridge.c */                                                                                                     \
    X(passenger_bridge)                                                                                                \
    /* presses.c */                                                                                                    \
    X(push_button)                                                                                                     \
    X(rocker_switch)                                                                                                   \
    X(pop_up_toaster)                                                                                                  \
    /* brewers.c */                                                                                                    \
    X(blender)                                                                                                         \
    X(coffee_maker)                                                                                                    \
    /* pedestals.c */                                                                                                  \
    X(pedestal)                                                                                                        \
    /* seats.c */                                                                                                      \
    X(office_chair)                                                                                                    \
    /* vessels.c */                                                                                                    \
    X(rov)                                                                                                             \
    X(torpedo)                                                                                                         \
    X(boat)                                                                                                            \
    /* gauges.c */                                                                                                     \
    X(dashboard)                                                                                                       \
    /* headsets.c */                                                                                                   \
    X(headset)                                                                                                         \
    /* winds.c */                                                                                                      \
    X(power_turbine)                                                                                                   \
    X(windmill)                                                                                                        \
    X(wind_mast)                                                                                                       \
    /* pods.c */                                                                                                       \
    X(finger_controller)                                                                                               \
    X(trigger_tool)                                                                                                    \
    X(squeeze_handle)                                                                                                  \
    /* clams.c */                                                                                                      \
    X(shell_case)                                                                                                      \
    X(waffle_iron)                                                                                                     \
    X(door_box)                                                                                                        \
    X(swing_bin)                                                                                                       \
    X(drop_pot)                                                                                                        \
    /* stands.c */                                                                                                     \
    X(recliner)                                                                                                        \
    X(flat_cart)                                                                                                       \
    X(folding_table)                                                                                                   \
    /* airframes.c */                                                                                                  \
    X(airframe)                                                                                                        \
    X(slotted_wing)                                                                                                    \
    /* gear.c */                                                                                                       \
    X(gear_leg)                                                                                                        \
    X(hull_bay)                                                                                                        \
    X(canopy)                                                                                                          \
    /* holds.c */                                                                                                      \
    X(rotor_head)                                                                                                      \
    X(cargo_hold)                                                                                                      \
    /* manipulators.c */                                                                                               \
    X(cobot_arm)                                                                                                       \
    X(scara)                                                                                                           \
    X(gantry)                                                                                                          \
    X(jaw_gripper)                                                                                                     \
    /* walkers.c */                                                                                                    \
    X(plate_legs)                                                                                                      \
    X(insect_robot)                                                                                                    \
    X(robot_hand)                                                                                                      \
    /* models.c */                                                                                                     \
    X(bare_model)                                                                                                      \
    /* boards.c */                                                                                                     \
    X(task_board)                                                                                                      \
    /* lifts.c */                                                                                                      \
    X(lift_column)                                                                                                     \
    X(stacked_axes)                                                                                                    \
    /* screens.c */                                                                                                    \
    X(monitor)                                                                                                         \
    X(convertible)                                                                                                     \
    /* microscopes.c */                                                                                                \
    X(microscope)                                                                                                      \
    /* sights.c */                                                                                                     \
    X(theodolite)                                                                                                      \
    X(sextant)                                                                                                         \
    /* crawlers.c */                                                                                                   \
    X(flipper_robot)                                                                                                   \
    X(rover)                                                                                                           \
    /* exoskeletons.c */                                                                                               \
    X(exoskeleton)                                                                                                     \
    /* parallels.c */                                                                                                  \
    X(parallel_robot)                                                                                                  \
    /* thrusters.c */                                                                                                  \
    X(tilt_rotor)                                                                                                      \
    /* heads.c */                                                                                                      \
    X(sensor_head)                                                                                                     \
    /* siege.c */                                                                                                      \
    X(siege_engine)                                                                                                    \
    /* arms.c */                                                                                                       \
    X(firearm)                                                                                                         \
    X(crossbow)                                                                                                        \
    /* wands.c */                                                                                                      \
    X(wand_controller)                                                                                                 \
    /* vaults.c */                                                                                                     \
    X(sarcophagus)                                                                                                     \
    X(well)                                                                                                            \
    X(dungeon_gate)                                                                                                    \
    /* hoods.c */                                                                                                      \
    X(grill)                                                                                                           \
    /* bread_bins.c */                                                                                                 \
    X(bread_bin)                                                                                                       \
    /* primitives.c */                                                                                                 \
    X(collision_model)                                                                                                 \
    /* hands.c */                                                                                                      \
    X(finger_hand)                                                                                                     \
    /* diggers.c */                                                                                                    \
    X(excavator)                                                                                                       \
    /* lifters.c */                                                                                                    \
    X(forklift)                                                                                                        \
    /* tippers.c */                                                                                                    \
    X(tipper)                                                                                                          \
    /* aerials.c */                                                                                                    \
    X(service_truck)                                                                                                   \
    /* pulls.c */                                                                                                      \
    X(push_pull_panel)                                                                                                 \
    X(sunk_wheels)                                                                                                     \
    /* gates.c */                                                                                                      \
    X(gate_lever)                                                                                                      \
    X(ship_control)                                                                                                    \
    /* horizons.c */                                                                                                   \
    X(horizon_gauge)                                                                                                   \
    /* benches.c */                                                                                                    \
    X(bench_set)                                                                                                       \
    X(centrifuge)                                                                                                      \
    /* fold_fronts.c */                                                                                                \
    X(tilt_cabinet)                                                                                                    \
    X(wall_bed)                                                                                                        \
    X(fold_desk)                                                                                                       \
    /* contour_cases.c */                                                                                              \
    X(contour_case)                                                                                                    \
    /* clinic.c */                                                                                                     \
    X(treatment_chair)                                                                                                 \
    X(hospital_bed)                                                                                                    \
    /* amusements.c */                                                                                                 \
    X(arcade_cabinet)                                                                                                  \
    X(pinball_table)                                                                                                   \
    X(music_box)                                                                                                       \
    /* carts.c */                                                                                                      \
    X(market_cart)                                                                                                     \
    /* ramps.c */                                                                                                      \
    X(belt_loader)                                                                                                     \
    X(airstairs)                                                                                                       \
    /* sails.c */                                                                                                      \
    X(sailing_boat)                                                                                                    \
    /* mice.c */                                                                                                       \
    X(computer_mouse)                                                                                                  \
    /* tripods.c */                                                                                                    \
    X(tripod)                                                                                                          \
    /* nacelles.c */                                                                                                   \
    X(thrust_reverser)                                                                                                 \
    X(jet_nozzle)                                                                                                      \
    /* skips.c */                                                                                                      \
    X(dumpster)                                                                                                        \
    /* sluices.c */                                                                                                    \
    X(sluice_gate)                                                                                                     \
    /* flush.c */                                                                                                      \
    X(flush_cabinet)                                                                                                   \
    /* corners.c */                                                                                                    \
    X(corner_cabinet)                                                                                                  \
    /* vanities.c */                                                                                                   \
    X(vanity)                                                                                                          \
    /* portals.c */                                                                                                    \
    X(scifi_door)                                                                                                      \
    /* hatches.c */                                                                                                    \
    X(pressure_hatch)                                                                                                  \
    /* armour.c */                                                                                                     \
    X(gun_vehicle)                                                                                                     \
    /* stage.c */                                                                                                      \
    X(stage_light)                                                                                                     \
    /* players.c */                                                                                                    \
    X(record_player)                                                                                                   \
    /* engines.c */                                                                                                    \
    X(piston_engine)                                                                                                   \
    /* cabins.c */                                                                                                     \
    X(cabin_door)                                                                                                      \
    X(cabin_seat)                                                                                                      \
    /* sofas.c */                                                                                                      \
    X(sofa_bed)                                                                                                        \
    /* lathes.c */                                                                                                     \
    X(lathe)                                                                                                           \
    /* playground.c */                                                                                                 \
    X(playground_piece)                                                                                                \
    /* play_panels.c */                                                                                                \
    X(play_panel)                                                                                                      \
    /* secrets.c */                                                                                                    \
    X(secret_wall)                                                                                                     \
    /* starships.c */                                                                                                  \
    X(starship)                                                                                                        \
    /* pianos.c */                                                                                                     \
    X(piano)                                                                                                           \
    /* sewing.c */                                                                                                     \
    X(sewing_machine)                                                                                                  \
    /* trimmers.c */                                                                                                   \
    X(paper_cutter)                                                                                                    \
    X(hole_punch)                                                                                                      \
    /* airers.c */                                                                                                     \
    X(clothes_airer)                                                                                                   \
    /* mills.c */                                                                                                      \
    X(milling_machine)                                                                                                 \
    /* cots.c */                                                                                                       \
    X(cot)                                                                                                             \
    /* cowlings.c */                                                                                                   \
    X(cowling)                                                                                                         \
    /* tables.c */                                                                                                     \
    X(extending_table)                                                                                                 \
    /* consoles.c */                                                                                                   \
    X(synthesizer)                                                                                                     \
    X(sound_desk)                                                                                                      \
    /* forecourt.c */                                                                                                  \
    X(fuel_pump)                                                                                                       \
    X(ticket_machine)                                                                                                  \
    /* cages.c */                                                                                                      \
    X(mine_cart)                                                                                                       \
    X(lift_cage)                                                                                                       \
    /* extruders.c */                                                                                                  \
    X(solid_printer)                                                                                                   \
    /* coaches.c */                                                                                                    \
    X(bus)                                                                                                             \
    /* interiors.c */                                                                                                  \
    X(car_interior)                                                                                                    \
    /* vehicle_seats.c */                                                                                              \
    X(car_seat)                                                                                                        \
    /* brass.c */                                                                                                      \
    X(wind_instrument)                                                                                                 \
    /* mechanisms.c */                                                                                                 \
    X(crank_bench)                                                                                                     \
    /* cycles.c */                                                                                                     \
    X(cycle)                                                                                                           \
    /* airships.c */                                                                                                   \
    X(airship)                                                                                                         \
    /* rigs.c */                                                                                                       \
    X(link_rig)                                                                                                        \
    /* farm.c */                                                                                                       \
    X(farm_machine)                                                                                                    \
    /* pocket.c */                                                                                                     \
    X(clamshell)                                                                                                       \
    /* portables.c */                                                                                                  \
    X(radio)                                                                                                           \
    /* recorders.c */                                                                                                  \
    X(recorder)                                                                                                        \
    X(game_console)                                                                                                    \
    /* watches.c */                                                                                                    \
    X(wrist_watch)                                                                                                     \
    X(metronome)                                                                                                       \
    /* carried.c */                                                                                                    \
    X(binoculars)                                                                                                      \
    X(lantern)                                                                                                         \
    /* sports.c */                                                                                                     \
    X(gym_machine)                                                                                                     \
    /* parlour.c */                                                                                                    \
    X(ball_game)                                                                                                       \
    /* antiques.c */                                                                                                   \
    X(period_cabinet)                                                                                                  \
    /* moderns.c */                                                                                                    \
    X(modern_unit)                                                                                                     \
    X(glass_case)                                                                                                      \
    /* retro.c */                                                                                                      \
    X(curved_appliance)                                                                                                \
    X(slot_toaster)                                                                                                    \
    /* coffers.c */                                                                                                    \
    X(vault_safe)                                                                                                      \
    X(soft_luggage)                                                                                                    \
    /* fixtures.c */                                                                                                   \
    X(toilet_suite)                                                                                                    \
    X(gas_hob)                                                                                                         \
    /* stools.c */                                                                                                     \
    X(lamp_stand)                                                                                                      \
    X(stool_chair)                                                                                                     \
    /* wastebins.c */                                                                                                  \
    X(hinged_bin)                                                                                                      \
    /* fryers.c */                                                                                                     \
    X(air_fryer)                                                                                                       \
    X(rice_cooker)                                                                                                     \
    X(salad_spinner)                                                                                                   \
    /* grinders.c */                                                                                                   \
    X(hand_mill)                                                                                                       \
    /* squeezers.c */                                                                                                  \
    X(hand_squeezer)                                                                                                   \
    /* openers.c */                                                                                                    \
    X(corkscrew)                                                                                                       \
    X(can_opener)                                                                                                      \
    /* prams.c */                                                                                                      \
    X(pushchair)                                                                                                       \
    X(high_chair)                                                                                                      \
    /* parasols.c */                                                                                                   \
    X(ironing_board)                                                                                                   \
    X(parasol)                                                                                                         \
    /* brackets.c */                                                                                                   \
    X(wall_arm)                                                                                                        \
    X(pet_crate)                                                                                                       \
    /* trains.c */                                                                                                     \
    X(locomotive)                                                                                                      \
    /* wagons.c */                                                                                                     \
    X(rail_wagon)                                                                                                      \
    /* signals.c */                                                                                                    \
    X(rail_signal)                                                                                                     \
    /* dozers.c */                                                                                                     \
    X(bulldozer)                                                                                                       \
    /* gliders.c */                                                                                                    \
    X(glider)                                                                                                          \
    /* haulers.c */                                                                                                    \
    X(mixer_truck)                                                                                                     \
    X(fire_engine)                                                                                                     \
    /* gondolas.c */                                                                                                   \
    X(cable_car)                                                                                                       \
    /* landers.c */                                                                                                    \
    X(lander)                                                                                                          \
    /* cannons.c */                                                                                                    \
    X(water_cannon)                                                                                                    \
    /* drilling.c */                                                                                                   \
    X(drill_press)                                                                                                     \
    X(hand_drill)                                                                                                      \
    /* sawing.c */                                                                                                     \
    X(mitre_saw)                                                                                                       \
    X(table_saw)                                                                                                       \
    X(band_saw)                                                                                                        \
    /* clamping.c */                                                                                                   \
    X(clamp)                                                                                                           \
    X(measuring_tool)                                                                                                  \
    /* jacks.c */                                                                                                      \
    X(scissor_jack)                                                                                                    \
    X(winch)                                                                                                           \
    /* records.c */                                                                                                    \
    X(filing_cabinet)                                                                                                  \
    X(computer_tower)                                                                                                  \
    /* copiers.c */                                                                                                    \
    X(photocopier)                                                                                                     \
    X(cash_register)                                                                                                   \
    /* desks.c */                                                                                                      \
    X(projector)                                                                                                       \
    X(drafting_table)                                                                                                  \
    X(desk_phone)                                                                                                      \
    /* lobbies.c */                                                                                                    \
    X(revolving_door)                                                                                                  \
    X(lift_doors)                                                                                                      \
    /* plants.c */                                                                                                     \
    X(roll_conveyor)                                                                                                   \
    X(boiler)                                                                                                          \
    /* streets.c */                                                                                                    \
    X(hydrant)                                                                                                         \
    X(meter_box)                                                                                                       \
    /* freight.c */                                                                                                    \
    X(shipping_container)                                                                                              \
    /* vents.c */                                                                                                      \
    X(roof_vent)                                                                                                       \
    /* theatres.c */                                                                                                   \
    X(c_arm)                                                                                                           \
    X(operating_lamp)                                                                                                  \
    /* wards.c */                                                                                                      \
    X(incubator)                                                                                                       \
    /* balances.c */                                                                                                   \
    X(cart_pole)                                                                                                       \
    /* grips.c */                                                                                                      \
    X(ring_controller)                                                                                                 \
    X(puck_controller)                                                                                                 \
    X(flight_stick)                                                                                                    \
    X(pistol_controller)                                                                                               \
    /* quadrants.c */                                                                                                  \
    X(throttle_quadrant)                                                                                               \
    X(racing_wheel)                                                                                                    \
    X(drum_pedal)                                                                                                      \
    /* bars.c */                                                                                                       \
    X(bike_controls)                                                                                                   \
    /* keyworks.c */                                                                                                   \
    X(key_stack)                                                                                                       \
    X(switch_panel)                                                                                                    \
    /* escutcheons.c */                                                                                                \
    X(door_furniture)                                                                                                  \
    /* cameras.c */                                                                                                    \
    X(camera_body)                                                                                                     \
    /* gimbals.c */                                                                                                    \
    X(stick_box)                                                                                                       \
    /* hand_levers.c */                                                                                                \
    X(hand_exerciser)                                                                                                  \
    /* watchers.c */                                                                                                   \
    X(security_camera)                                                                                                 \
    /* pallets.c */                                                                                                    \
    X(pallet_truck)                                                                                                    \
    /* tabletops.c */                                                                                                  \
    X(drawer_table)                                                                                                    \
    /* extractors.c */                                                                                                 \
    X(range_hood)                                                                                                      \
    /* showers.c */                                                                                                    \
    X(shower)                                                                                                          \
    /* toys.c */                                                                                                       \
    X(toy_vehicle)                                                                                                     \
    /* campware.c */                                                                                                   \
    X(folding_stool)                                                                                                   \
    /* decks.c */                                                                                                      \
    X(ship_deck)

#define DMG_DECLARE(name) void dmg_build_##name(dmg_builder* b);
DMG_CATEGORIES(DMG_DECLARE)
#undef DMG_DECLARE

#endif
